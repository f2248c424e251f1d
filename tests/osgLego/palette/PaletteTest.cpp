#include <osgLego/Palette.h>
#include <osgLego/PartType.h>
#include <osgLego/palette/Oklab.h>

#include <Palettes.h>

#include <algorithm>
#include <bit>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

osg::ref_ptr<const Palette> readDefault()
{
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read("ldraw", error);
    EXPECT_TRUE(palette) << error;
    return palette;
}

osg::ref_ptr<const Palette> createRandom(std::size_t count)
{
    std::mt19937 engine(5);
    std::vector<PaletteColor> colors(count);
    for (PaletteColor& color : colors)
        for (std::uint8_t& channel : color.color)
            channel = static_cast<std::uint8_t>(engine());
    return createPalette(colors);
}

const PaletteColor* findCode(const Palette& palette, std::int32_t code)
{
    const auto colors = palette.getColors();
    const auto place =
        std::find_if(colors.begin(), colors.end(), [&](const PaletteColor& color) { return color.code == code; });
    return place == colors.end() ? nullptr : &*place;
}

using Places = std::vector<glm::dvec3>;

/** The colours of a palette in Oklab. */
Places placesOf(const Palette& palette)
{
    Places places;
    for (const PaletteColor& color : palette.getColors())
        places.push_back(toOklab(color.color));
    return places;
}

/** The distance from a place to the nearest of all. */
double leastDistance(const Places& places, const glm::dvec3& place)
{
    double least = 10.0;
    for (const glm::dvec3& other : places)
        least = std::min(least, glm::distance(other, place));
    return least;
}

/** The lowest colour of an entry of the table. */
Color firstOf(std::size_t entry)
{
    const auto levelOf = [](std::size_t step) { return static_cast<std::uint8_t>(4 * step); };
    return {levelOf(entry % 64), levelOf(entry / 64 % 64), levelOf(entry / 64 / 64)};
}

/** The middle of the entry of a colour. */
Color middleOf(Color color)
{
    for (std::uint8_t& channel : color)
        channel = static_cast<std::uint8_t>(channel / 4 * 4 + 2);
    return color;
}

bool isInEntryOf(const Color& color, const Color& other)
{
    return middleOf(color) == middleOf(other);
}

TEST(Oklab, HasThePublishedValues)
{
    // Ottosson's article gives the first two, to three digits, for the white point and the primaries of sRGB.
    const auto expectNear = [](const glm::dvec3& actual, const glm::dvec3& expected)
    { EXPECT_LT(glm::distance(actual, expected), 1e-3) << actual.x << ' ' << actual.y << ' ' << actual.z; };
    expectNear(toOklab({255, 255, 255}), {1.0, 0.0, 0.0});
    expectNear(toOklab({255, 0, 0}), {0.628, 0.225, 0.126});
    expectNear(toOklab({0, 255, 0}), {0.866, -0.234, 0.179});
    expectNear(toOklab({0, 0, 255}), {0.452, -0.032, -0.312});
    expectNear(toOklab({0, 0, 0}), {0.0, 0.0, 0.0});
}

TEST(Palette, TheDefaultColoursExistInNearlyAllSizesAndCanBeOrdered)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    EXPECT_EQ(palette->getColors().size(), 33u);
    for (const PaletteColor& color : palette->getColors())
    {
        EXPECT_GT(color.brickLink, 0) << color.name;
        EXPECT_TRUE(color.bricks & color.plates & 1) << color.name;
        EXPECT_GE(std::popcount(color.bricks) + std::popcount(color.plates), 20) << color.name;
    }
}

TEST(Palette, TheDefaultColoursAreThoseOfLDraw)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    const PaletteColor* red = findCode(*palette, 4);
    ASSERT_NE(red, nullptr);
    EXPECT_EQ(red->name, "Red");
    EXPECT_EQ(red->color, (Color{0xb4, 0x00, 0x00}));
    EXPECT_EQ(red->brickLink, 5);
    EXPECT_EQ(red->bricks, PaletteColor::ALL_SIZES);
    const PaletteColor* tan = findCode(*palette, 28);
    ASSERT_NE(tan, nullptr);
    EXPECT_EQ(tan->bricks, PaletteColor::ALL_SIZES & ~(1u << 10)); // no brick 2x8 was made
    EXPECT_EQ((PART_SIZES[10]), (std::array<int, 2>{2, 8}));
}

TEST(Palette, TheDefaultLeavesOutColoursThatAreHardToGet)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    EXPECT_EQ(findCode(*palette, 9), nullptr);   // made in one size
    EXPECT_EQ(findCode(*palette, 112), nullptr); // has no number of BrickLink
    EXPECT_EQ(findCode(*palette, 16), nullptr);  // stands for another colour
}

TEST(Palette, EveryColourIsItsOwnNearest)
{
    for (const osg::ref_ptr<const Palette>& palette : {readDefault(), createRandom(Palette::MAXIMUM_COLORS)})
        for (const PaletteColor& color : palette->getColors())
            EXPECT_EQ(palette->getColors()[palette->findNearest(color.color)].color, color.color) << color.name;
}

TEST(Palette, TheFirstOfEqualColoursIsFound)
{
    const osg::ref_ptr<const Palette> palette =
        createPalette({{1, "a", {9, 9, 9}}, {2, "b", {200, 0, 0}}, {3, "c", {200, 0, 0}}});
    EXPECT_EQ(palette->findNearest({200, 0, 0}), 1u);
    EXPECT_EQ(palette->findNearest({220, 10, 10}), 1u);
}

TEST(Palette, TheFirstOfColoursInOneEntryOfTheTableIsFoundForBoth)
{
    const osg::ref_ptr<const Palette> palette =
        createPalette({{1, "a", {9, 9, 9}}, {2, "b", {201, 1, 1}}, {3, "c", {202, 2, 2}}});
    EXPECT_EQ(palette->findNearest({201, 1, 1}), 1u);
    EXPECT_EQ(palette->findNearest({202, 2, 2}), 1u);
    EXPECT_EQ(palette->findDithered({201, 1, 1}, {3, 5, 7}), 1u);
}

TEST(Palette, HasOneTo255Colours)
{
    std::string error;
    EXPECT_TRUE(Palette::create(std::vector<PaletteColor>(1), error));
    EXPECT_TRUE(Palette::create(std::vector<PaletteColor>(255), error));
    EXPECT_EQ(error, "");
    EXPECT_FALSE(Palette::create({}, error));
    EXPECT_EQ(error, "the palette has 0 colours; expected 1 to 255");
    EXPECT_FALSE(Palette::create(std::vector<PaletteColor>(256), error));
    EXPECT_EQ(error, "the palette has 256 colours; expected 1 to 255");
}

TEST(Palette, APaletteOfOneColourHasNoOther)
{
    const osg::ref_ptr<const Palette> palette = createPalette({{4, "Red", {180, 0, 0}}});
    EXPECT_EQ(palette->findNearest({0, 255, 255}), 0u);
    EXPECT_EQ(palette->findDithered({90, 200, 10}, {3, 5, 7}), 0u);
}

TEST(Palette, TheTableHasTheColourNearestToTheMiddleOfEachEntry)
{
    for (const osg::ref_ptr<const Palette>& palette : {readDefault(), createRandom(Palette::MAXIMUM_COLORS)})
    {
        const Places places = placesOf(*palette);
        ASSERT_EQ(palette->getTable().size(), 64u * 64u * 64u);
        for (std::size_t entry = 0; entry < palette->getTable().size(); entry += 7)
        {
            const Color first = firstOf(entry);
            const std::size_t index = palette->getTable()[entry];
            ASSERT_LT(index, palette->getColors().size());
            if (isInEntryOf(palette->getColors()[index].color, first)) continue;
            const glm::dvec3 middle = toOklab(middleOf(first));
            ASSERT_LT(glm::distance(places[index], middle), leastDistance(places, middle) + 1e-6);
        }
    }
}

TEST(Palette, TheTableDiffersFromTheExactNearestOnlyWhereTwoAreAlmostEquallyNear)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    const Places places = placesOf(*palette);
    std::mt19937 engine(3);
    int numDifferent = 0;
    constexpr int NUM_COLORS = 20000;
    for (int number = 0; number < NUM_COLORS; ++number)
    {
        const auto bits = static_cast<std::uint32_t>(engine());
        const Color color{static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                          static_cast<std::uint8_t>(bits >> 16)};
        const std::size_t index = palette->findNearest(color);
        const glm::dvec3 place = toOklab(color);
        const double difference = glm::distance(places[index], place) - leastDistance(places, place);
        numDifferent += difference > 0.0 ? 1 : 0;
        // By the triangle inequality: the table is right in the middle of the entry, or the colour is in the entry.
        const glm::dvec3 middle = toOklab(middleOf(color));
        const double reach = glm::distance(place, middle);
        const double reachOfOther =
            isInEntryOf(palette->getColors()[index].color, color) ? glm::distance(places[index], middle) : 0.0;
        ASSERT_LE(difference, 2.0 * (reach + reachOfOther) + 1e-6);
    }
    EXPECT_LT(numDifferent, NUM_COLORS * 4 / 100);
    EXPECT_GT(numDifferent, 0);
}

} // namespace

} // namespace osgLego
