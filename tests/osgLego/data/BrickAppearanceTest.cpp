#include <osgLego/BrickAppearance.h>

#include <limits>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

osg::ref_ptr<osg::Image> createImage(int width, int height, int depth = 1)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, depth, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    return image;
}

TEST(BrickAppearance, NumbersHaveRanges)
{
    struct Range
    {
        double BrickAppearance::*member;
        const char* name;
        double minimum;
        double maximum;
    };
    EXPECT_TRUE(BrickAppearance().check().empty());
    for (const Range& range : {Range{&BrickAppearance::reliefHeight, "reliefHeight", 0.0, 0.2},
                               Range{&BrickAppearance::roughness, "roughness", 0.05, 1.0},
                               Range{&BrickAppearance::variation, "variation", 0.0, 5.0},
                               Range{&BrickAppearance::outline, "outline", 0.0, 8.0}})
    {
        const auto errorOf = [&](double value)
        {
            BrickAppearance appearance;
            appearance.*range.member = value;
            return appearance.check();
        };
        EXPECT_EQ(errorOf(range.minimum), "");
        EXPECT_EQ(errorOf(range.maximum), "");
        for (const double bad : {range.minimum - 1e-9, range.maximum + 1e-9, -1.0,
                                 std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
            EXPECT_NE(errorOf(bad).find(range.name), std::string::npos) << range.name << " " << bad;
        EXPECT_NE(errorOf(-1.0).find("; expected "), std::string::npos);
    }
}

TEST(BrickAppearance, AReliefIsAFlatImageOfLimitedSize)
{
    const auto errorOf = [](const osg::ref_ptr<osg::Image>& image)
    {
        BrickAppearance appearance;
        appearance.reliefImage = image;
        return appearance.check();
    };
    EXPECT_EQ(errorOf(nullptr), "");
    EXPECT_EQ(errorOf(createImage(1, 1)), "");
    EXPECT_EQ(errorOf(createImage(2048, 3)), "");
    for (const osg::ref_ptr<osg::Image>& image :
         {osg::ref_ptr<osg::Image>(new osg::Image), createImage(2049, 1), createImage(1, 2049), createImage(4, 4, 2)})
        EXPECT_NE(errorOf(image).find("1 to 2048 pixels"), std::string::npos);
    osg::ref_ptr<osg::Image> compressed = new osg::Image;
    compressed->allocateImage(8, 8, 1, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_UNSIGNED_BYTE);
    EXPECT_FALSE(errorOf(compressed).empty());
}

} // namespace

} // namespace osgLego
