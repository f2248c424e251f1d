#include <osgLego/LightProbe.h>

#include <Probes.h>
#include <TemporaryFolder.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

namespace osgLego::test
{

namespace
{

osg::Vec3d warmSky(const osg::Vec3d& direction)
{
    return osg::Vec3d(1.0, 0.75, 0.5) * (1.0 + 0.5 * direction.z() + 0.25 * direction.x());
}

class LightProbeRead : public TemporaryFolderTest
{
protected:
    std::string writeProbe(const std::string& name, const osg::Image& image) const
    {
        EXPECT_TRUE(osgDB::writeImageFile(image, pathOf(name) + ".oiio")) << name;
        return pathOf(name);
    }

    std::string writeText(const std::string& name, const std::string& text) const
    {
        std::ofstream(pathOf(name), std::ios::binary) << text;
        return pathOf(name);
    }

    /** The error of reading a file: one line that contains the file's name. */
    static std::string errorOf(const std::string& fileName)
    {
        std::string error;
        EXPECT_FALSE(LightProbe::read(fileName, error)) << fileName;
        EXPECT_NE(error.find("'" + fileName + "'"), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        return error;
    }
};

TEST_F(LightProbeRead, ReadsExrAndHdr)
{
    for (const auto& [name, tolerance] : {std::pair("probe.exr", 1e-4), std::pair("probe.hdr", 0.01)})
    {
        const std::string fileName = writeProbe(name, *createLatitudeLongitude(64, warmSky));
        std::string error;
        const osg::ref_ptr<LightProbe> probe = LightProbe::read(fileName, error);
        ASSERT_TRUE(probe) << error;
        const osg::ref_ptr<LightProbe> expected = new LightProbe;
        ASSERT_TRUE(expected->setImage(createLatitudeLongitude(64, warmSky), LightProbe::AUTO, error)) << error;
        for (const osg::Vec3d& normal : createNormals())
            EXPECT_LT((probe->getIrradiance(normal) - expected->getIrradiance(normal)).length(), tolerance) << name;
    }
}

TEST_F(LightProbeRead, ReadsAngularMaps)
{
    const std::string fileName = writeProbe("angular.exr", *createAngularMap(100, warmSky));
    std::string error;
    const osg::ref_ptr<LightProbe> probe = LightProbe::read(fileName, error);
    ASSERT_TRUE(probe) << error;
    EXPECT_NEAR(probe->getIrradiance({0.0, 0.0, 1.0}).x(), 1.0 + 2.0 / 3.0 * 0.5, 0.01);
    EXPECT_NEAR(probe->getIrradiance({1.0, 0.0, 0.0}).x(), 1.0 + 2.0 / 3.0 * 0.25, 0.01);
}

TEST_F(LightProbeRead, TruncatedFilesAreErrors)
{
    // A pattern that run-length encoding can't compress.
    const auto pattern = [](const osg::Vec3d& d) { return osg::Vec3d(2.0 + d.x(), 2.0 + d.y(), 2.0 + d.z()); };
    for (const std::string extension : {".exr", ".hdr"})
    {
        const std::string whole = contentsOf(writeProbe("whole" + extension, *createLatitudeLongitude(64, pattern)));
        for (const std::size_t size : {std::size_t(0), std::size_t(10), std::size_t(100), whole.size() / 2})
            EXPECT_NE(errorOf(writeText("part" + extension, whole.substr(0, size))).find("can't be read: "),
                      std::string::npos);
    }
}

TEST_F(LightProbeRead, ACorruptHeaderDoesNoHarm)
{
    const std::string fileName = writeText("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 40000 +X 40000\n");
    EXPECT_NE(errorOf(fileName).find("40000 x 40000"), std::string::npos);
}

TEST_F(LightProbeRead, ReportsTheReasonForAFailure)
{
    EXPECT_NE(errorOf(pathOf("none.exr")).find("was not found"), std::string::npos);
    EXPECT_NE(errorOf(writeText("text.txt", "light\n")).find("can't be read: "), std::string::npos);
    EXPECT_NE(errorOf(writeText("text.exr", "light\n")).find("can't be read: "), std::string::npos);
    EXPECT_NE(errorOf(writeText("text", "light\n")).find("can't be read: "), std::string::npos);
    EXPECT_NE(errorOf(_folder.string()).find("can't be read: "), std::string::npos);

    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(8, 4, 1, GL_LUMINANCE_ALPHA, GL_FLOAT);
    std::memset(image->data(), 0, image->getTotalSizeInBytes());
    EXPECT_NE(errorOf(writeProbe("two.exr", *image)).find("2 channels"), std::string::npos);
    image->allocateImage(9, 3, 1, GL_RGB, GL_FLOAT);
    std::memset(image->data(), 0, image->getTotalSizeInBytes());
    EXPECT_NE(errorOf(writeProbe("wide.exr", *image)).find("9 x 3 pixels; expected"), std::string::npos);
}

/** Photographed probes, which scripts/fetch-models downloads. */
class PhotographedProbe : public ::testing::TestWithParam<const char*>
{
};

TEST_P(PhotographedProbe, IrradianceEqualsTheSumOverAllPixels)
{
    const char* folder = std::getenv("OSGLEGO_TEST_MODELS");
    const std::string fileName = std::string(folder ? folder : ".") + "/" + GetParam();
    if (!std::ifstream(fileName)) GTEST_SKIP() << "without " << fileName << " (see scripts/fetch-models)";

    std::string error;
    const osg::ref_ptr<LightProbe> probe = LightProbe::read(fileName, error);
    ASSERT_TRUE(probe) << error;
    const osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(fileName + ".oiio");
    ASSERT_TRUE(image);
    const std::vector<osg::Vec3d> normals = createNormals();
    const std::vector<osg::Vec3d> sums = sumIrradiance(*image, normals);
    osg::Vec3d sum;
    osg::Vec3d squares;
    for (std::size_t index = 0; index < normals.size(); ++index)
    {
        const osg::Vec3d irradiance = probe->getIrradiance(normals[index]);
        const osg::Vec3d difference = irradiance - sums[index];
        sum += sums[index];
        squares += osg::componentMultiply(difference, difference);
        EXPECT_GE(std::min({irradiance.x(), irradiance.y(), irradiance.z()}), 0.0);
    }
    // The root mean square error, relative to the mean.
    const auto count = static_cast<double>(normals.size());
    for (unsigned int channel = 0; channel < 3; ++channel)
        EXPECT_LT(std::sqrt(squares[channel] / count), 0.02 * sum[channel] / count) << "channel " << channel;
}

INSTANTIATE_TEST_SUITE_P(LightProbeRead, PhotographedProbe, ::testing::Values("probe.exr", "probe-indoor.exr"));

} // namespace

} // namespace osgLego::test
