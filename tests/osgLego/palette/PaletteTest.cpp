#include <osgLego/Palette.h>
#include <osgLego/PartType.h>
#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/MatchingLab.h>

#include <Palettes.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <oneapi/tbb/task_group.h>

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

/** The places at which the colours of a palette are matched. */
Places placesOf(const Palette& palette)
{
    Places places;
    for (const PaletteColor& color : palette.getColors())
        places.push_back(toMatchingLab(color.color));
    return places;
}

/** The difference of a place from the nearest of all. */
double leastDifference(const Places& places, const glm::dvec3& place)
{
    double least = 1000.0;
    for (const glm::dvec3& other : places)
        least = std::min(least, ciede2000(other, place));
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

TEST(Palette, TheDefaultColoursExistInNearlyAllSizesAndCanBeOrdered)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    EXPECT_EQ(palette->getColors().size(), 30u);
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

TEST(Palette, TheDefaultLeavesOutRetiredColoursThatAPaletteMayAskFor)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    for (const std::int32_t code : {6, 7, 8}) // Brown, Light Grey and Dark Grey
    {
        EXPECT_EQ(findCode(*palette, code), nullptr) << code;
        const std::span<const PaletteColor> known = Palette::getKnownColors();
        EXPECT_TRUE(std::any_of(known.begin(), known.end(), [&](const PaletteColor& own) { return own.code == code; }));
    }
}

TEST(Palette, DifferencesAre100FromBlackToWhiteAndSmallForSimilarColours)
{
    EXPECT_NEAR(Palette::getDifference({0, 0, 0}, {255, 255, 255}), 100.0, 1e-6);
    EXPECT_EQ(Palette::getDifference({88, 42, 18}, {88, 42, 18}), 0.0);
    EXPECT_LT(Palette::getDifference({180, 0, 0}, {183, 3, 2}), 2.0);
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

osg::ref_ptr<const Palette> createGrey(std::uint8_t level)
{
    return createPalette({{0, "grey", {level, level, level}}});
}

TEST(Palette, TheSixteenThatWereUsedLastAreShared)
{
    std::vector<osg::ref_ptr<const Palette>> palettes;
    for (std::uint8_t level = 0; level < 16; ++level)
        palettes.push_back(createGrey(level));
    EXPECT_EQ(createGrey(0), palettes[0]);
    createGrey(16); // takes the place of the grey 1, which has not been used for longest
    EXPECT_EQ(createGrey(0), palettes[0]);
    for (std::uint8_t level = 2; level < 16; ++level)
        EXPECT_EQ(createGrey(level), palettes[level]) << int{level};
    EXPECT_NE(createGrey(1), palettes[1]);
}

TEST(Palette, KeepsCompleteMixturesEvenIfTheTaskThatAsksForThemFirstIsCancelled)
{
    osg::ref_ptr<const Palette> palette = createPalette({{4, "Red", {181, 0, 0}}, {15, "White", {240, 241, 242}}});
    oneapi::tbb::task_group group;
    group.run_and_wait(
        [&]
        {
            group.cancel();
            palette->getMixtures();
        });
    for (std::uint16_t x = 0; x < 4; ++x)
        EXPECT_EQ(palette->findDithered({255, 255, 255}, {x, 0, 0}), 1u) << x;
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
        for (std::size_t entry = 0; entry < palette->getTable().size(); entry += 29)
        {
            const Color first = firstOf(entry);
            const std::size_t index = palette->getTable()[entry];
            ASSERT_LT(index, palette->getColors().size());
            if (isInEntryOf(palette->getColors()[index].color, first)) continue;
            const glm::dvec3 middle = toMatchingLab(middleOf(first));
            ASSERT_LT(ciede2000(places[index], middle), leastDifference(places, middle) + 1e-6);
        }
    }
}

/** How much worse the colours of a palette's table are than the nearest colours. */
struct Excess
{
    double mean = 0.0;
    double maximum = 0.0;
};

Excess excessOf(const Palette& palette, const std::vector<Color>& colors)
{
    const Places places = placesOf(palette);
    Excess excess;
    for (const Color& color : colors)
    {
        const glm::dvec3 place = toMatchingLab(color);
        const double difference = ciede2000(places[palette.findNearest(color)], place) - leastDifference(places, place);
        excess.mean += difference / static_cast<double>(colors.size());
        excess.maximum = std::max(excess.maximum, difference);
    }
    return excess;
}

TEST(Palette, TheTableIsHardlyWorseThanTheExactNearest)
{
    std::mt19937 engine(3);
    std::vector<Color> colors(20000);
    for (Color& color : colors)
        for (std::uint8_t& channel : color)
            channel = static_cast<std::uint8_t>(engine());
    const Excess excess = excessOf(*readDefault(), colors);
    EXPECT_LT(excess.mean, 0.03);
    EXPECT_LT(excess.maximum, 3.0);
    EXPECT_GT(excess.maximum, 0.0);
}

double chromaOf(const Color& color)
{
    const glm::dvec3 place = toCieLab(color);
    return std::hypot(place.y, place.z);
}

TEST(Palette, NearlyNeutralColoursStayNeutral)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    int numNeutral = 0;
    int numChromatic = 0;
    for (int red = 0; red < 256; red += 3)
        for (int green = std::max(red - 15, 0); green <= std::min(red + 15, 255); green += 3)
            for (int blue = std::max(red - 15, 0); blue <= std::min(red + 15, 255); blue += 3)
            {
                const Color color{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                                  static_cast<std::uint8_t>(blue)};
                if (chromaOf(color) > 5.0) continue;
                ++numNeutral;
                numChromatic += chromaOf(palette->getColors()[palette->findNearest(color)].color) > 10.0 ? 1 : 0;
            }
    EXPECT_GT(numNeutral, 3000);
    EXPECT_LE(numChromatic, numNeutral / 100);
}

/** A colour of a mesh, and the codes of the palette's colours that have its name. */
struct NamedColor
{
    Color color;
    std::vector<std::int32_t> codes;
};

void expectNames(const std::vector<NamedColor>& named)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    for (const auto& [color, codes] : named)
    {
        const PaletteColor& nearest = palette->getColors()[palette->findNearest(color)];
        EXPECT_NE(std::ranges::find(codes, nearest.code), codes.end())
            << +color[0] << ' ' << +color[1] << ' ' << +color[2] << ": " << nearest.name;
    }
}

TEST(Palette, BluesOfDisplaysAreBlueNotPurple)
{
    expectNames({{{0, 0, 255}, {1}},
                 {{0, 0, 204}, {1}},
                 {{51, 51, 204}, {1}},
                 {{30, 60, 220}, {1}},
                 {{0, 0, 200}, {1, 272}},
                 {{0, 0, 150}, {1, 272}},
                 {{0, 0, 128}, {272}},
                 {{0, 0, 100}, {272}},
                 {{25, 25, 112}, {272}}});
}

TEST(Palette, YellowsOfDisplaysAreYellowNotCream)
{
    expectNames({{{255, 255, 0}, {14}},
                 {{255, 255, 26}, {14}},
                 {{255, 240, 0}, {14}},
                 {{230, 230, 0}, {14}},
                 {{204, 204, 0}, {14}},
                 {{255, 255, 128}, {226}}}); // is cream
}

TEST(Palette, OtherColoursOfDisplaysKeepTheirNames)
{
    expectNames({{{255, 0, 0}, {4}},
                 {{128, 0, 0}, {320}},
                 {{0, 128, 0}, {2}},
                 {{128, 255, 0}, {27}},
                 {{255, 165, 0}, {191}},
                 {{255, 128, 0}, {25}},
                 {{139, 69, 19}, {484}},
                 {{75, 0, 130}, {85}},
                 {{128, 0, 128}, {85}},
                 {{255, 0, 255}, {5}},
                 {{0, 128, 128}, {3}},
                 {{100, 149, 237}, {73}},
                 {{173, 216, 230}, {212}},
                 {{234, 192, 134}, {19}}});
}

TEST(Palette, EveryGreyIsBuiltOfGrey)
{
    const osg::ref_ptr<const Palette> palette = readDefault();
    for (int level = 0; level < 256; ++level)
    {
        const auto channel = static_cast<std::uint8_t>(level);
        const PaletteColor& nearest = palette->getColors()[palette->findNearest({channel, channel, channel})];
        EXPECT_LE(chromaOf(nearest.color), 5.0) << level << ' ' << nearest.name;
    }
}

} // namespace

} // namespace osgLego
