#include <osgLego/flattening/SourceColors.h>
#include <osgLego/flattening/SourcePalette.h>

#include <common/RacingCar.h>

#include <Meshes.h>
#include <Settings.h>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osg/Shape>
#include <osg/ShapeDrawable>
#include <osg/Texture2D>

namespace osgLego::test
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

osg::ref_ptr<const GridTriangles> createTriangles(osg::Node& node, const std::string& text)
{
    return GridTriangles::create(*SceneTriangles::create(node), parseSettings(text));
}

void paint(osg::Geometry& geometry, const osg::Vec4& color)
{
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(1, &color);
    geometry.setColorArray(colors, osg::Array::BIND_OVERALL);
}

/** A rectangle in the plane z = height, from (0, 0) on. */
osg::ref_ptr<osg::Geometry> createRectangle(float x, float width, float depth, float height, const osg::Vec4& color)
{
    osg::ref_ptr<osg::Geometry> rectangle =
        osg::createTexturedQuadGeometry({x, 0, height}, {width, 0, 0}, {0, depth, 0});
    paint(*rectangle, color);
    return rectangle;
}

osg::ref_ptr<osg::Node> createBox(float halfSide, const osg::Vec4& color)
{
    osg::ref_ptr<osg::ShapeDrawable> box = new osg::ShapeDrawable(new osg::Box({0, 0, 0}, 2.0f * halfSide));
    box->setColor(color);
    return box;
}

/** The share of a colour in the histogram, 0 to 1. */
double shareOf(const ColorHistogram& histogram, const Color& color)
{
    double sum = 0.0;
    double found = 0.0;
    for (const ColorShare& share : histogram.getShares())
    {
        sum += share.weight;
        if (share.color == color) found = share.weight;
    }
    return found / sum;
}

constexpr Color RED{255, 0, 0};
constexpr Color GREEN{0, 255, 0};
constexpr Color BLUE{0, 0, 255};

TEST(SourceColors, AreWeightedByArea)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(createRectangle(0, 1, 10, 0, {1, 0, 0, 1}));
    geode->addDrawable(createRectangle(1, 3, 10, 0, {0, 1, 0, 1}));
    geode->addDrawable(createRectangle(4, 6, 10, 0, {0, 0, 1, 1}));
    const ColorHistogram histogram = histogramOf(*createTriangles(*geode, "20"));
    EXPECT_NEAR(shareOf(histogram, RED), 0.1, 0.001);
    EXPECT_NEAR(shareOf(histogram, GREEN), 0.3, 0.001);
    EXPECT_NEAR(shareOf(histogram, BLUE), 0.6, 0.001);
}

TEST(SourceColors, DoNotDependOnTheSizeOfTriangles)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(createRectangle(0, 5, 10, 0, {1, 0, 0, 1}));
    for (int strip = 0; strip < 500; ++strip)
        geode->addDrawable(createRectangle(5.0f + 0.01f * static_cast<float>(strip), 0.01f, 10, 0, {0, 1, 0, 1}));
    EXPECT_NEAR(shareOf(histogramOf(*createTriangles(*geode, "20")), RED), 0.5, 0.001);
}

TEST(SourceColors, AreThoseOfTheTexture)
{
    // The left quarter of the picture is red, and the rest is blue.
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(64, 64, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (unsigned int row = 0; row < 64; ++row)
        for (unsigned int column = 0; column < 64; ++column)
            std::copy_n(column < 16 ? RED.data() : BLUE.data(), 3, image->data(column, row));
    osg::ref_ptr<osg::Geometry> square = createRectangle(0, 1, 1, 0, {1, 1, 1, 1});
    square->getOrCreateStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D(image));
    const ColorHistogram histogram = histogramOf(*createTriangles(*square, "32"));
    EXPECT_NEAR(shareOf(histogram, RED), 0.25, 0.03);
    EXPECT_NEAR(shareOf(histogram, BLUE), 0.75, 0.03);
}

TEST(SourceColors, AreInterpolatedBetweenCorners)
{
    osg::ref_ptr<osg::Geometry> triangle = createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    for (const osg::Vec4& color : {osg::Vec4(1, 0, 0, 1), osg::Vec4(0, 1, 0, 1), osg::Vec4(0, 0, 1, 1)})
        colors->push_back(color);
    triangle->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
    std::array<double, 3> sums{};
    double weight = 0.0;
    for (const ColorShare& share : histogramOf(*createTriangles(*triangle, "16")).getShares())
    {
        for (std::size_t channel = 0; channel < 3; ++channel)
            sums[channel] += share.weight * share.color[channel];
        weight += share.weight;
    }
    for (const double sum : sums)
        EXPECT_NEAR(sum / weight, 255.0 / 3.0, 1.0);
}

TEST(SourceColors, LeaveOutTheInsideOfAClosedSurface)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createBox(1.0f, {1, 0, 0, 1}));
    group->addChild(createBox(0.5f, {0, 1, 0, 1}));
    const ColorHistogram closed = histogramOf(*createTriangles(*group, "48"));
    EXPECT_EQ(shareOf(closed, RED), 1.0);
    EXPECT_EQ(shareOf(closed, GREEN), 0.0);
    // Without its shell, the inner box is seen.
    osg::ref_ptr<osg::Group> open = new osg::Group;
    open->addChild(createRectangle(-1, 2, 2, -1, {1, 0, 0, 1}));
    open->addChild(createBox(0.5f, {0, 1, 0, 1}));
    EXPECT_GT(shareOf(histogramOf(*createTriangles(*open, "48")), GREEN), 0.5);
}

TEST(SourceColors, AreThoseInsideTheGrid)
{
    // Most of the red ground is outside; in the grid, it has the size of the green square.
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(osg::createTexturedQuadGeometry({-2000, -2000, 0.5}, {4000, 0, 0}, {0, 4000, 0}));
    paint(*geode->getDrawable(0)->asGeometry(), {1, 0, 0, 1});
    geode->addDrawable(createRectangle(0, 16, 16, 8.5, {0, 1, 0, 1}));
    const ColorHistogram histogram = histogramOf(*createTriangles(*geode, "cell=1,origin=0:0:0,size=16:16:16"));
    EXPECT_NEAR(shareOf(histogram, RED), 0.5, 0.01);
    EXPECT_NEAR(shareOf(histogram, GREEN), 0.5, 0.01);
}

TEST(SourceColors, SurfacesWithoutAreaCountToo)
{
    // Two triangles so narrow that the corners of the blue one coincide in single precision.
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const double x : {0.0, 8.0})
    {
        const osg::ref_ptr<osg::Geometry> triangle = createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 4});
        paint(*triangle, {0, 0, x > 0.0 ? 1.0f : 0.0f, 1});
        osg::ref_ptr<osg::MatrixTransform> transform =
            new osg::MatrixTransform(osg::Matrixd::scale(1e-9, 1, 1) * osg::Matrixd::translate(x, 0, 0));
        transform->addChild(triangle);
        group->addChild(transform);
    }
    EXPECT_NEAR(shareOf(histogramOf(*createTriangles(*group, "16")), BLUE), 0.5, 0.1);
    const osg::ref_ptr<osg::Group> empty = new osg::Group;
    EXPECT_TRUE(histogramOf(*createTriangles(*empty, "8")).getShares().empty());
}

TEST(SourcePalette, IsTheBestChoiceForTheSource)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(createRectangle(0, 5, 10, 0, {0.71f, 0, 0, 1}));
    geode->addDrawable(createRectangle(5, 4, 10, 0, {0.98f, 0.78f, 0.04f, 1}));
    geode->addDrawable(createRectangle(9, 1, 10, 0, {0.96f, 0.96f, 0.96f, 1}));
    LegoSettings settings;
    settings.colors.palette = "ldraw";
    settings.colors.count = 3;
    const osg::ref_ptr<const GridTriangles> triangles = createTriangles(*geode, "20");
    const osg::ref_ptr<const Palette> ldraw = SettingsPalette::read(settings).palette;
    const osg::ref_ptr<const Palette> palette = paletteOf(settings, ldraw, *triangles);
    ASSERT_TRUE(palette);
    std::set<std::string> names;
    for (const PaletteColor& color : palette->getColors())
        names.insert(color.name);
    EXPECT_EQ(names, (std::set<std::string>{"Red", "Yellow", "White"}));
    settings.colors.count = 200;
    EXPECT_EQ(paletteOf(settings, ldraw, *triangles)->getColors().size(), 30u);
    settings.colors.count.reset();
    EXPECT_EQ(paletteOf(settings, ldraw, *triangles)->getColors().size(), 30u);
    settings.colors.palette = "none";
    EXPECT_EQ(SettingsPalette::read(settings), SettingsPalette());
    EXPECT_FALSE(paletteOf(settings, nullptr, *triangles));
    settings.colors.palette = "missing.csv";
    EXPECT_FALSE(SettingsPalette::read(settings).palette);
    EXPECT_EQ(SettingsPalette::read(settings).error,
              "missing.csv: the palette can't be read: No such file or directory");
}

TEST(SourcePalette, IsTheSameOnEveryRun)
{
    LegoSettings settings;
    settings.colors.palette = "ldraw";
    settings.colors.count = 6;
    const osg::ref_ptr<const Palette> ldraw = SettingsPalette::read(settings).palette;
    const auto choose = [&]
    {
        std::vector<std::int32_t> codes;
        const osg::ref_ptr<const GridTriangles> triangles = createTriangles(*createRacingCar(), "64");
        const osg::ref_ptr<const Palette> palette = paletteOf(settings, ldraw, *triangles);
        for (const PaletteColor& color : palette->getColors())
            codes.push_back(color.code);
        return codes;
    };
    EXPECT_EQ(choose(), choose());
}

} // namespace

} // namespace osgLego::test
