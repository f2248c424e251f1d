#include "ProbeChecks.h"

#include <Notices.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using namespace test;

std::string errorOf(const osg::ref_ptr<osg::Image>& image, LightProbe::Mapping mapping = LightProbe::AUTO)
{
    const osg::ref_ptr<LightProbe> probe = new LightProbe;
    const osg::Vec3d before = probe->getIrradiance({0.0, 0.0, 1.0});
    std::string error;
    EXPECT_FALSE(probe->setImage(image, mapping, error));
    EXPECT_EQ(probe->getIrradiance({0.0, 0.0, 1.0}), before);
    EXPECT_EQ(probe->getImage(), nullptr);
    return error;
}

TEST(LightProbePicture, EachAxisHasItsPlaceInThePicture)
{
    struct Axis
    {
        osg::Vec3d direction;
        osg::Vec3d color;
        int column, row; // of the first reflection
    };
    const std::vector<Axis> axes{{{1, 0, 0}, {1, 0, 0}, 192, 64}, {{-1, 0, 0}, {0, 1, 1}, 64, 64},
                                 {{0, 1, 0}, {0, 1, 0}, 128, 64}, {{0, -1, 0}, {1, 0, 1}, 0, 64},
                                 {{0, 0, 1}, {0, 0, 1}, 0, 127},  {{0, 0, -1}, {1, 1, 0}, 0, 0}};
    const auto lamps = [&](const osg::Vec3d& direction)
    {
        osg::Vec3d sum;
        for (const Axis& axis : axes)
            if (direction * axis.direction > 0.97) sum += axis.color * 20.0;
        return sum;
    };
    for (const auto& probe : createProbes(lamps))
        for (const Axis& axis : axes)
        {
            expectNear(pixelOf(*probe->getReflectionMap(0), axis.column, axis.row), axis.color * 20.0, 1e-3);
            const osg::Vec3d irradiance = probe->getIrradiance(axis.direction);
            double least = std::numeric_limits<double>::max();
            double most = 0.0;
            for (unsigned int channel = 0; channel < 3; ++channel)
            {
                double& bound = axis.color[channel] > 0.0 ? least : most;
                bound = axis.color[channel] > 0.0 ? std::min(bound, irradiance[channel])
                                                  : std::max(bound, irradiance[channel]);
            }
            EXPECT_GT(least, 2.0 * most) << axis.column << " " << axis.row;
        }
}

TEST(LightProbePicture, InvalidPixelsAreRepaired)
{
    const float bad[]{std::numeric_limits<float>::quiet_NaN(), -5.0f, -std::numeric_limits<float>::infinity()};
    const osg::ref_ptr<osg::Image> image = createLatitudeLongitude(64, constant(1.0));
    const osg::ref_ptr<osg::Image> mended = createLatitudeLongitude(64, constant(1.0));
    for (unsigned int index = 0; index < 3; ++index)
    {
        reinterpret_cast<osg::Vec3f*>(image->data(10 + index, 20))->x() = bad[index];
        reinterpret_cast<osg::Vec3f*>(mended->data(10 + index, 20))->x() = 0.0f;
    }
    reinterpret_cast<osg::Vec3f*>(image->data(30, 10))->y() = std::numeric_limits<float>::infinity();
    reinterpret_cast<osg::Vec3f*>(mended->data(30, 10))->y() = 65504.0f;

    osg::ref_ptr<LightProbe> probe;
    const std::string notices = noticesOf([&] { probe = createProbe(image); });
    EXPECT_NE(
        notices.find("3 pixels of a light probe's picture with negative values or without numbers; they count as 0\n"),
        std::string::npos)
        << notices;
    EXPECT_NE(notices.find("1 infinite pixel of a light probe's picture; they count as 65504\n"), std::string::npos)
        << notices;
    EXPECT_EQ(probe->getCoefficients(), createProbe(mended)->getCoefficients());
    EXPECT_GT(probe->getIrradiance({1.0, 0.0, 0.0}).x(), 0.0);
}

TEST(LightProbePicture, APictureWithoutLightIsRefused)
{
    const std::string expected = "expected at least one finite pixel above 0";
    for (const float value :
         {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_NE(errorOf(createLatitudeLongitude(8, constant(value))).find(expected), std::string::npos) << value;
}

TEST(LightProbePicture, UnsupportedPicturesAreRefused)
{
    EXPECT_NE(errorOf(new osg::Image).find("no pixels"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(300, 100)).find("300 x 100 pixels; expected twice as wide"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(3, 1)).find("expected"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(1, 2)).find("expected"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(8, 4), LightProbe::ANGULAR).find("expected a square"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(8, 4, GL_LUMINANCE_ALPHA)).find("2 channels"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(8, 4, GL_RG)).find("2 channels"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(8, 4, GL_DEPTH_COMPONENT)).find("expected grey"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(8, 4, GL_RGB, GL_INT)).find("expected floats"), std::string::npos);
    EXPECT_NE(errorOf(createEmptyImage(8, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_UNSIGNED_BYTE)).find("expected"),
              std::string::npos);
    const osg::ref_ptr<osg::Image> volume = new osg::Image;
    volume->allocateImage(8, 4, 2, GL_RGB, GL_FLOAT);
    EXPECT_NE(errorOf(volume).find("2 layers"), std::string::npos);
}

TEST(LightProbePicture, EveryKindOfPixelIsRead)
{
    for (const GLenum format : std::initializer_list<GLenum>{GL_LUMINANCE, GL_RED, GL_RGB, GL_RGBA, GL_BGR, GL_BGRA})
        for (const GLenum type : std::initializer_list<GLenum>{GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT})
        {
            // Rows of 6 pixels are followed by padding.
            const osg::ref_ptr<osg::Image> image = new osg::Image;
            image->allocateImage(6, 3, 1, format, type, 8);
            const unsigned int channels = osg::Image::computeNumComponents(format);
            for (unsigned int row = 0; row < 3; ++row)
                for (unsigned int index = 0; index < 6 * channels; ++index)
                {
                    // In display values, the first channel is half the second and third; the fourth is 0.
                    const double value = index % channels == 0 ? 0.5 : (index % channels == 3 ? 0.0 : 1.0);
                    unsigned char* data = image->data(0, row);
                    if (type == GL_UNSIGNED_BYTE) data[index] = static_cast<unsigned char>(255.0 * value + 0.5);
                    const auto word = static_cast<unsigned short>(65535.0 * value + 0.5);
                    if (type == GL_UNSIGNED_SHORT) std::memcpy(data + 2 * index, &word, 2);
                    const auto number = static_cast<float>(value);
                    if (type == GL_FLOAT) std::memcpy(data + 4 * index, &number, 4);
                }
            const double half = type == GL_FLOAT ? 0.5 : (type == GL_UNSIGNED_BYTE ? 0.21586 : 0.21404);
            osg::Vec3d expected(half, 1.0, 1.0);
            if (channels == 1) expected = grey(half);
            if (format == GL_BGR || format == GL_BGRA) expected.set(1.0, 1.0, half);
            expectNear(createProbe(image)->getIrradiance({0.0, 1.0, 0.0}), expected, 1e-3);
        }
}

TEST(LightProbePicture, TinyPicturesAreEnough)
{
    const osg::ref_ptr<osg::Image> halves = createEmptyImage(2, 1);
    reinterpret_cast<osg::Vec3f*>(halves->data(1, 0))->set(1.0f, 1.0f, 1.0f); // +X
    const osg::ref_ptr<LightProbe> right = createProbe(halves);
    EXPECT_NEAR(right->getIrradiance({1.0, 0.0, 0.0}).x(), 1.0, 0.02);
    EXPECT_NEAR(right->getIrradiance({0.0, 0.0, 1.0}).x(), 0.5, 0.02);
    EXPECT_NEAR(right->getIrradiance({-1.0, 0.0, 0.0}).x(), 0.0, 0.02);

    const osg::ref_ptr<osg::Image> stacked = createEmptyImage(1, 2);
    reinterpret_cast<osg::Vec3f*>(stacked->data(0, 1))->set(1.0f, 1.0f, 1.0f); // +Z
    EXPECT_NEAR(createProbe(stacked, LightProbe::LATITUDE_LONGITUDE)->getIrradiance({0.0, 0.0, 1.0}).x(), 1.0, 0.02);

    const osg::ref_ptr<osg::Image> one = createEmptyImage(1, 1);
    reinterpret_cast<osg::Vec3f*>(one->data())->set(1.0f, 1.0f, 1.0f);
    expectNear(createProbe(one)->getIrradiance({0.0, 1.0, 0.0}), grey(1.0), 2e-3);
}

} // namespace

} // namespace osgLego
