#include <osgLego/flattening/SurfaceTexture.h>

#include <algorithm>
#include <array>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** Two texels across: black, white. */
osg::ref_ptr<osg::Texture2D> createBlackAndWhite(osg::Texture::WrapMode wrap)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    image->data()[0] = 0;
    image->data()[1] = 255;
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    texture->setBorderColor(osg::Vec4d(0.25, 0.5, 0.75, 1.0));
    return texture;
}

double redAt(osg::Texture::WrapMode wrap, double s, double level = 0.0)
{
    return SurfaceTexture::create(*createBlackAndWhite(wrap))->sample({s, 0.5}, level).r;
}

TEST(SurfaceTexture, InterpolatesBetweenTheCentresOfTexels)
{
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 0.25), 0.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 0.5), 0.5, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 0.625), 0.75, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 0.75), 1.0, 1e-9);
}

TEST(SurfaceTexture, FollowsTheWrapMode)
{
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 1.25), 1.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP, 1.25), 1.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::REPEAT, 1.25), 0.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::REPEAT, -1000.25), 1.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::REPEAT, 0.0), 0.5, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::MIRROR, 1.25), 1.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::MIRROR, 1.75), 0.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::MIRROR, 0.0), 0.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_BORDER, 1.5), 0.25, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_BORDER, 1e300), 0.25, 1e-9);
}

TEST(SurfaceTexture, LevelsAreAveragesAndAreInterpolated)
{
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 0.75, 1.0), 128.0 / 255.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 0.75, 0.5), 0.5 + 64.0 / 255.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 0.75, 99.0), 128.0 / 255.0, 1e-9);
    EXPECT_NEAR(redAt(osg::Texture::CLAMP_TO_EDGE, 0.75, -1.0), 1.0, 1e-9);
}

TEST(SurfaceTexture, AnOddSizeKeepsItsMean)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(5, 3, 1, GL_RGB, GL_FLOAT);
    float sum = 0.0f;
    for (unsigned int index = 0; index < 15; ++index)
    {
        auto* texel = reinterpret_cast<float*>(image->data(index % 5, index / 5));
        texel[0] = texel[1] = texel[2] = static_cast<float>(index) / 14.0f;
        sum += texel[0];
    }
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    EXPECT_NEAR(SurfaceTexture::create(*texture)->sample({0.5, 0.5}, 99.0).r, static_cast<double>(sum) / 15.0,
                0.51 / 255.0);
}

TEST(SurfaceTexture, TexelsAndBordersThatAreNotFiniteAreReplaced)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(1, 1, 1, GL_RGB, GL_FLOAT);
    const std::array<float, 3> texel{nan, infinity, -infinity};
    std::copy(texel.begin(), texel.end(), reinterpret_cast<float*>(image->data()));
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_BORDER);
    texture->setBorderColor(osg::Vec4(infinity, nan, -infinity, 0.5f));
    const osg::ref_ptr<SurfaceTexture> surface = SurfaceTexture::create(*texture);
    EXPECT_EQ(surface->sample({0.5, 0.5}, 0.0), glm::dvec4(0, 1, 0, 1));
    EXPECT_EQ(surface->sample({9.5, 0.5}, 0.0), glm::dvec4(1, 0, 0, 0.5));
    EXPECT_EQ(surface->getBorderColor(), osg::Vec4d(1, 0, 0, 0.5));
    for (const double coordinate : {static_cast<double>(nan), static_cast<double>(infinity)})
    {
        EXPECT_EQ(surface->sample({coordinate, coordinate}, 0.0), surface->sample({0.0, 0.0}, 0.0));
        EXPECT_EQ(surface->getTexel({coordinate, coordinate}, 0), surface->sample({0.5, 0.5}, 0.0));
    }
}

TEST(SurfaceTexture, TheCentresOfTexelsHaveTheirColors)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(8, 4, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (unsigned int byte = 0; byte < image->getTotalSizeInBytes(); ++byte)
        image->data()[byte] = static_cast<unsigned char>(37 * byte % 251);
    for (const osg::Texture::WrapMode wrap :
         {osg::Texture::REPEAT, osg::Texture::MIRROR, osg::Texture::CLAMP_TO_EDGE, osg::Texture::CLAMP_TO_BORDER})
    {
        const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
        texture->setWrap(osg::Texture::WRAP_S, wrap);
        texture->setWrap(osg::Texture::WRAP_T, wrap);
        const osg::ref_ptr<SurfaceTexture> surface = SurfaceTexture::create(*texture);
        for (const int level : {0, 1, 2, 3, 9})
            for (int column = -9; column < 17; ++column)
                for (int row = -5; row < 9; ++row)
                {
                    const glm::dvec2 size = glm::max(glm::ivec2(8, 4) >> std::min(level, 3), 1);
                    const glm::dvec2 center = (glm::dvec2(column, row) + 0.5) / size;
                    const glm::dvec4 difference = surface->getTexel(center, level) - surface->sample(center, level);
                    EXPECT_LT(glm::length(difference), 1e-9) << wrap << ' ' << level << ' ' << column << ' ' << row;
                }
    }
}

TEST(SurfaceTexture, UnreadableImagesGiveNoTexture)
{
    EXPECT_FALSE(SurfaceTexture::create(*osg::ref_ptr<osg::Texture2D>(new osg::Texture2D)));
    osg::ref_ptr<osg::Image> compressed = new osg::Image;
    auto* data = new unsigned char[8]{};
    compressed->setImage(4, 4, 1, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_UNSIGNED_BYTE,
                         data, osg::Image::USE_NEW_DELETE);
    EXPECT_FALSE(SurfaceTexture::create(*osg::ref_ptr<osg::Texture2D>(new osg::Texture2D(compressed))));
}

TEST(SurfaceTexture, AHugeImageIsHalvedUntilItFits)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2 * SurfaceTexture::MAXIMUM_SIZE, 2, 1, GL_RGB, GL_UNSIGNED_BYTE);
    std::fill_n(image->data(), image->getTotalSizeInBytes(), static_cast<unsigned char>(200));
    const osg::ref_ptr<SurfaceTexture> surface =
        SurfaceTexture::create(*osg::ref_ptr<osg::Texture2D>(new osg::Texture2D(image)));
    EXPECT_EQ(surface->getSize(), glm::ivec2(SurfaceTexture::MAXIMUM_SIZE, 1));
    EXPECT_NEAR(surface->sample({0.3, 0.5}, 2.0).g, 200.0 / 255.0, 1e-9);
}

} // namespace

} // namespace osgLego
