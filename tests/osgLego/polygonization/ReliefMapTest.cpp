#include <osgLego/polygonization/ReliefMap.h>

#include <cmath>

#include <gtest/gtest.h>
#include <osg/Vec4f>

namespace osgLego
{

namespace
{

int countLevels(const osg::Image& map)
{
    return static_cast<int>(map.getNumMipmapLevels());
}

/** The mean of the texels of a level. */
osg::Vec4d meanOf(const osg::Image& map, int level)
{
    const int side = map.s() >> level;
    const auto* texels = reinterpret_cast<const osg::Vec4f*>(map.getMipmapData(static_cast<unsigned int>(level)));
    osg::Vec4d sum;
    for (int index = 0; index < side * side; ++index)
        sum += osg::Vec4d(texels[index]);
    return sum / (side * side);
}

/** A picture of floats with a height for each pixel. */
template <typename Height>
osg::ref_ptr<osg::Image> createHeights(int width, int height, const Height& heightOf)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_LUMINANCE, GL_FLOAT);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            *reinterpret_cast<float*>(image->data(static_cast<unsigned int>(column), static_cast<unsigned int>(row))) =
                static_cast<float>(heightOf((column + 0.5) / width, (row + 0.5) / height));
    return image;
}

void expectSound(const osg::Image& map)
{
    ASSERT_EQ(map.s(), map.t());
    ASSERT_EQ(map.getPixelFormat(), static_cast<GLenum>(GL_RGBA));
    ASSERT_EQ(map.getDataType(), static_cast<GLenum>(GL_FLOAT));
    ASSERT_EQ(map.s() >> (countLevels(map) - 1), 1) << "the last level is of one texel";
    const osg::Vec4d first = meanOf(map, 0);
    for (int level = 0; level < countLevels(map); ++level)
    {
        const osg::Vec4d mean = meanOf(map, level);
        EXPECT_NEAR(mean.x(), first.x(), 1e-4) << level;
        EXPECT_NEAR(mean.y(), first.y(), 1e-4) << level;
        EXPECT_NEAR(mean.z(), first.z(), 1e-4 * (1.0 + first.z())) << level;
        EXPECT_EQ(mean.w(), 0.0);
        EXPECT_GE(mean.z(), mean.x() * mean.x() + mean.y() * mean.y()) << "squares are never less than their mean's";
    }
}

TEST(ReliefMap, EveryLevelOfTheOwnReliefHasItsMeans)
{
    const osg::ref_ptr<osg::Image> map = createReliefMap(nullptr);
    expectSound(*map);
    // Every rise is followed by a fall before the rim of the disk.
    EXPECT_NEAR(meanOf(*map, 0).x(), 0.0, 1e-4);
    EXPECT_NEAR(meanOf(*map, 0).y(), 0.0, 1e-4);
    EXPECT_GT(meanOf(*map, 0).z(), 0.5) << "there is a relief";
    EXPECT_EQ(createReliefMap(nullptr), map) << "it is shared";
}

TEST(ReliefMap, ABlackPictureHasNoSlopesAndAWhiteOneOnlyAtTheRim)
{
    const osg::ref_ptr<osg::Image> black = createReliefMap(createHeights(32, 32, [](double, double) { return 0.0; }));
    expectSound(*black);
    EXPECT_EQ(meanOf(*black, 0), osg::Vec4d());
    const osg::ref_ptr<osg::Image> white = createReliefMap(createHeights(32, 32, [](double, double) { return 1.0; }));
    expectSound(*white);
    EXPECT_GT(meanOf(*white, 0).z(), 0.0);
    for (int row = 0; row < white->t(); ++row)
        for (int column = 0; column < white->s(); ++column)
        {
            const double x = 2.0 * (column + 0.5) / white->s() - 1.0;
            const double y = 2.0 * (row + 0.5) / white->t() - 1.0;
            if (std::hypot(x, y) > 0.75) continue;
            EXPECT_EQ(osg::Vec4(white->getColor(static_cast<unsigned int>(column), static_cast<unsigned int>(row))),
                      osg::Vec4(0, 0, 0, 0));
        }
}

TEST(ReliefMap, ASlopeIsThatOfThePicture)
{
    // A ramp along u, from 0 to 1 over the disk's diameter of two radii.
    const osg::ref_ptr<osg::Image> map = createReliefMap(createHeights(64, 64, [](double u, double) { return u; }));
    expectSound(*map);
    const osg::Vec4 middle =
        map->getColor(static_cast<unsigned int>(map->s() / 2), static_cast<unsigned int>(map->t() / 2));
    EXPECT_NEAR(middle.r(), 0.5, 1e-3);
    EXPECT_NEAR(middle.g(), 0.0, 1e-3);
    EXPECT_NEAR(middle.b(), 0.25, 1e-3);
}

TEST(ReliefMap, PicturesOfAnyShapeAreTaken)
{
    const auto heightOf = [](double u, double v) { return 0.5 + 0.5 * std::sin(20.0 * u) * std::cos(9.0 * v); };
    EXPECT_EQ(createReliefMap(createHeights(1, 1, heightOf))->s(), 1);
    expectSound(*createReliefMap(createHeights(1, 1, heightOf)));
    const osg::ref_ptr<osg::Image> wide = createReliefMap(createHeights(100, 7, heightOf));
    EXPECT_EQ(wide->s(), 128);
    expectSound(*wide);
    const auto strange = [](double u, double) { return u < 0.3 ? NAN : u < 0.6 ? INFINITY : -5.0; };
    expectSound(*createReliefMap(createHeights(16, 16, strange)));
}

} // namespace

} // namespace osgLego
