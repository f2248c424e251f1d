#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/MatchingLab.h>
#include <osgLego/palette/MixtureTable.h>
#include <osgLego/palette/NearestTable.h>

#include <Palettes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

osg::ref_ptr<const Palette> readDefaultColors()
{
    std::string error;
    return Palette::read("ldraw", error);
}

osg::ref_ptr<const Palette> createRandomColors(std::size_t count, unsigned int seed)
{
    std::mt19937 engine(seed);
    std::vector<PaletteColor> colors(count);
    for (PaletteColor& color : colors)
        for (std::uint8_t& channel : color.color)
            channel = static_cast<std::uint8_t>(engine());
    return createPalette(colors);
}

Color middleOfTableEntry(std::size_t entry)
{
    const auto at = [](std::size_t step) { return static_cast<std::uint8_t>(4 * (step % 64) + 2); };
    return {at(entry), at(entry / 64), at(entry / 4096)};
}

double chromaOfPlace(const glm::dvec3& place)
{
    return std::hypot(place.y, place.z);
}

/** The difference of a mixture from a colour, and 0.1 times the standard deviation of its bricks. */
double mixtureCost(const Palette& palette, const Color& color, std::size_t first, std::size_t second, double share)
{
    const Color& firstColor = palette.getColors()[first].color;
    const Color& secondColor = palette.getColors()[second].color;
    const glm::dvec3 mean = linearToMatchingLab(glm::mix(toLinear(firstColor), toLinear(secondColor), share));
    return ciede2000(toMatchingLab(color), mean) +
           0.1 * std::sqrt(share * (1.0 - share)) * ciede2000(toMatchingLab(firstColor), toMatchingLab(secondColor));
}

double mixtureCost(const Palette& palette, const Color& color, const PaletteMixture& mixture)
{
    return mixtureCost(palette, color, mixture.first, mixture.second, mixture.share / 256.0);
}

/** The least cost of all pairs of colours. */
double leastMixtureCost(const Palette& palette, const Color& color)
{
    double least = mixtureCost(palette, color, 0, 0, 0.0);
    for (std::size_t second = 0; second < palette.getColors().size(); ++second)
        for (std::size_t first = 0; first <= second; ++first)
            for (int share = 0; share < 64; ++share)
                least = std::min(least, mixtureCost(palette, color, first, second, share / 64.0));
    return least;
}

TEST(MixtureTable, HasNearlyTheBestOfAllPairs)
{
    for (unsigned int seed = 1; seed <= 8; ++seed)
    {
        const osg::ref_ptr<const Palette> palette = createRandomColors(9, seed);
        double excess = 0.0;
        int count = 0;
        for (std::size_t entry = 11 * seed; entry < palette->getMixtures().size(); entry += 3989)
        {
            const Color color = middleOfTableEntry(entry);
            // Bricks of near-neutral surfaces are nearly neutral, even if others imitate them better.
            if (chromaOfPlace(toCieLab(color)) < 30.0) continue;
            const double least = leastMixtureCost(*palette, color);
            // No mixture looks like a colour that is farther from all of them, and the choice hardly matters.
            if (least > 15.0) continue;
            excess += mixtureCost(*palette, color, palette->getMixtures()[entry]) - least;
            ++count;
        }
        ASSERT_GT(count, 5);
        EXPECT_LT(excess / count, 0.25) << seed;
    }
}

TEST(MixtureTable, IsNeverWorseThanTheNearestColour)
{
    for (const osg::ref_ptr<const Palette>& palette :
         {readDefaultColors(), createRandomColors(Palette::MAXIMUM_COLORS, 3)})
        for (std::size_t entry = 0; entry < palette->getMixtures().size(); entry += 7)
        {
            const Color color = middleOfTableEntry(entry);
            const std::size_t nearest = palette->getTable()[entry];
            ASSERT_LE(mixtureCost(*palette, color, palette->getMixtures()[entry]),
                      mixtureCost(*palette, color, nearest, nearest, 0.0) + 1e-9);
        }
}

TEST(MixtureTable, TheSecondColourIsLighterOrTheSame)
{
    for (const osg::ref_ptr<const Palette>& palette : {readDefaultColors(), createRandomColors(60, 4)})
        for (const auto& [first, second, share] : palette->getMixtures())
        {
            ASSERT_EQ(first == second, share == 0);
            if (share == 0) continue;
            ASSERT_LT(toCieLab(palette->getColors()[first].color).x, toCieLab(palette->getColors()[second].color).x);
        }
}

TEST(MixtureTable, NearlyNeutralSurfacesMixNearlyNeutralColours)
{
    const osg::ref_ptr<const Palette> palette = readDefaultColors();
    int numMixed = 0;
    for (int red = 0; red < 256; red += 3)
        for (int green = std::max(red - 12, 0); green < std::min(red + 13, 256); green += 3)
            for (int blue = std::max(red - 12, 0); blue < std::min(red + 13, 256); blue += 3)
            {
                const Color color{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                                  static_cast<std::uint8_t>(blue)};
                if (chromaOfPlace(toCieLab(color)) > 5.0) continue;
                const auto [first, second, share] = palette->getMixtures()[tableEntryOf(color)];
                if (share == 0) continue;
                ++numMixed;
                for (const std::size_t index : {first, second})
                    ASSERT_LE(chromaOfPlace(toCieLab(palette->getColors()[index].color)), 10.0)
                        << red << ' ' << green << ' ' << blue;
            }
    EXPECT_GT(numMixed, 1000);
}

TEST(MixtureTable, GreysAreImitatedAlthoughManyColoursAreNearer)
{
    // Of these, the 60 nearest to any grey are chromatic.
    std::vector<PaletteColor> colors{{0, "black", {0, 0, 0}}, {1, "white", {255, 255, 255}}};
    for (int number = 0; number < 60; ++number)
    {
        const auto level = static_cast<std::uint8_t>(4 * number);
        const auto other = static_cast<std::uint8_t>(level + 60 > 255 ? level - 60 : level + 60);
        colors.push_back({number + 2, "tint", {level, level, other}});
    }
    const osg::ref_ptr<const Palette> palette = createPalette(colors);
    for (const std::uint8_t level : std::array<std::uint8_t, 4>{80, 120, 160, 200})
    {
        const PaletteMixture mixture = palette->getMixtures()[tableEntryOf({level, level, level})];
        EXPECT_EQ(mixture.first, 0) << int(level);
        EXPECT_EQ(mixture.second, 1) << int(level);
        const double middle = toLinear(static_cast<std::uint8_t>(level / 4 * 4 + 2));
        EXPECT_NEAR(mixture.share / 256.0, middle, 0.01) << int(level);
    }
}

TEST(MixtureTable, BricksDifferOnlyWhereThatHelps)
{
    // Half a unit of lightness lighter than the grey: a mixture with white would be a little better, but speckled.
    const osg::ref_ptr<const Palette> palette =
        createPalette({{0, "grey", {120, 120, 120}}, {1, "white", {255, 255, 255}}});
    EXPECT_EQ(palette->getMixtures()[tableEntryOf({124, 124, 124})], (PaletteMixture{0, 0, 0}));
    EXPECT_GT(palette->getMixtures()[tableEntryOf({160, 160, 160})].share, 32);
}

TEST(MixtureTable, BluesHaveNoPurpleBricks)
{
    const osg::ref_ptr<const Palette> palette = readDefaultColors();
    for (const std::uint8_t level : std::array<std::uint8_t, 4>{255, 200, 150, 100})
    {
        const PaletteMixture mixture = palette->getMixtures()[tableEntryOf({0, 0, level})];
        for (const std::uint8_t index : {mixture.first, mixture.second})
            EXPECT_NE(palette->getColors()[index].name, "Medium_Lilac") << int(level);
    }
}

TEST(MixtureTable, AColourOfThePaletteStaysPlain)
{
    for (const osg::ref_ptr<const Palette>& palette :
         {readDefaultColors(), createRandomColors(Palette::MAXIMUM_COLORS, 5)})
        for (const PaletteColor& color : palette->getColors())
        {
            const std::size_t entry = tableEntryOf(color.color);
            const std::uint8_t nearest = palette->getTable()[entry];
            EXPECT_EQ(palette->getMixtures()[entry], (PaletteMixture{nearest, nearest, 0}));
        }
}

} // namespace

} // namespace osgLego
