#include <osgLego/data/VolumeMipmaps.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

osg::ref_ptr<osg::Image> createVolume(const glm::ivec3& size)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(size.x, size.y, size.z, GL_RGBA, GL_UNSIGNED_BYTE);
    return image;
}

/** A channel of a texel of a level, 0 to 255. */
int getByte(const osg::Image& image, unsigned int level, const glm::ivec3& texel, int channel)
{
    const glm::ivec3 size = glm::max(glm::ivec3(image.s(), image.t(), image.r()) >> static_cast<int>(level), 1);
    return image.getMipmapData(level)[4 * (texel.x + size.x * (texel.y + size.y * texel.z)) + channel];
}

} // namespace

TEST(VolumeMipmapsTest, ATexelIsTheMeanOfTheEightThatItCovers)
{
    const osg::ref_ptr<osg::Image> image = createVolume({8, 4, 2});
    std::mt19937 random(3);
    std::generate_n(image->data(), image->getTotalSizeInBytes(),
                    [&] { return static_cast<unsigned char>(random() % 256); });
    const osg::ref_ptr<osg::Image> mipmapped = createVolumeMipmaps(*image);
    ASSERT_EQ(mipmapped->getNumMipmapLevels(), 4u);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            for (int channel = 0; channel < 4; ++channel)
            {
                double sum = 0.0;
                for (int corner = 0; corner < 8; ++corner)
                    sum += getByte(*image, 0, {2 * x + (corner & 1), 2 * y + (corner >> 1 & 1), corner >> 2}, channel);
                EXPECT_NEAR(getByte(*mipmapped, 1, {x, y, 0}, channel), sum / 8.0, 0.51) << x << ' ' << y;
            }
}

TEST(VolumeMipmapsTest, TheFirstLevelIsTheImage)
{
    const osg::ref_ptr<osg::Image> image = createVolume({3, 5, 7});
    for (unsigned int place = 0; place < image->getTotalSizeInBytes(); ++place)
        image->data()[place] = static_cast<unsigned char>(place % 251);
    const osg::ref_ptr<osg::Image> mipmapped = createVolumeMipmaps(*image);
    EXPECT_TRUE(std::equal(image->data(), image->data() + image->getTotalSizeInBytes(), mipmapped->data()));
}

TEST(VolumeMipmapsTest, ATexelOfAnOddSideHasItsShareOfThoseBetween)
{
    const osg::ref_ptr<osg::Image> image = createVolume({5, 1, 1});
    std::fill_n(image->data(), 20, static_cast<unsigned char>(0));
    image->data(2, 0, 0)[0] = 250;
    image->data(4, 0, 0)[1] = 250;
    const osg::ref_ptr<osg::Image> mipmapped = createVolumeMipmaps(*image);
    EXPECT_EQ(getByte(*mipmapped, 1, {0, 0, 0}, 0), 50); // half of it in a texel of two and a half
    EXPECT_EQ(getByte(*mipmapped, 1, {1, 0, 0}, 0), 50);
    EXPECT_EQ(getByte(*mipmapped, 1, {0, 0, 0}, 1), 0);
    EXPECT_EQ(getByte(*mipmapped, 1, {1, 0, 0}, 1), 100);
}

TEST(VolumeMipmapsTest, TheLastLevelIsTheMeanOfAnySize)
{
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 1), glm::ivec3(9, 1, 4), glm::ivec3(13, 7, 21), glm::ivec3(3, 3, 3)})
    {
        const osg::ref_ptr<osg::Image> image = createVolume(size);
        std::fill_n(image->data(), image->getTotalSizeInBytes(), static_cast<unsigned char>(200));
        const osg::ref_ptr<osg::Image> mipmapped = createVolumeMipmaps(*image);
        const unsigned int last = static_cast<unsigned int>(mipmapped->getNumMipmapLevels()) - 1u;
        EXPECT_EQ(1 << last, 1 << static_cast<int>(std::log2(std::max({size.x, size.y, size.z}))));
        for (int channel = 0; channel < 4; ++channel)
            EXPECT_EQ(getByte(*mipmapped, last, {0, 0, 0}, channel), 200);
    }
}

} // namespace osgLego::test
