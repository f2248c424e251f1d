#include <osgLego/palette/ColorChoice.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/MatchingLab.h>

#include <Palettes.h>

#include <algorithm>
#include <bit>
#include <map>
#include <random>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

Color randomColor(std::mt19937& engine)
{
    const auto bits = static_cast<std::uint32_t>(engine());
    return {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
            static_cast<std::uint8_t>(bits >> 16)};
}

osg::ref_ptr<const Palette> randomPalette(std::mt19937& engine, std::size_t count)
{
    std::vector<PaletteColor> colors(count);
    for (std::size_t index = 0; index < count; ++index)
        colors[index] = {static_cast<std::int32_t>(index), "", randomColor(engine)};
    return createPalette(colors);
}

double errorOf(const std::vector<PaletteColor>& colors, const std::vector<ColorShare>& shares)
{
    double sum = 0.0;
    for (const ColorShare& share : shares)
    {
        double nearest = 1000.0;
        for (const PaletteColor& color : colors)
            nearest = std::min(nearest, ciede2000(toMatchingLab(color.color), toMatchingLab(share.color)));
        sum += share.weight * nearest * nearest;
    }
    return sum;
}

std::vector<PaletteColor> colorsOf(const Palette& palette)
{
    return {palette.getColors().begin(), palette.getColors().end()};
}

/** The least error of all subsets of a size. */
double leastError(const Palette& palette, const std::vector<ColorShare>& shares, std::size_t count)
{
    double least = 1e9;
    for (unsigned int set = 0; set < 1u << palette.getColors().size(); ++set)
    {
        if (static_cast<std::size_t>(std::popcount(set)) != count) continue;
        std::vector<PaletteColor> subset;
        for (std::size_t index = 0; index < palette.getColors().size(); ++index)
            if (set >> index & 1) subset.push_back(palette.getColors()[index]);
        least = std::min(least, errorOf(subset, shares));
    }
    return least;
}

ColorHistogram randomHistogram(std::mt19937& engine, int count)
{
    ColorHistogram histogram;
    for (int number = 0; number < count; ++number)
        histogram.add(randomColor(engine), std::uniform_real_distribution<double>(1.0, 100.0)(engine));
    return histogram;
}

TEST(ColorChoice, HasTheLeastErrorOfAllSubsets)
{
    std::mt19937 engine(1);
    int numBest = 0;
    int numCases = 0;
    for (int round = 0; round < 8; ++round)
    {
        const osg::ref_ptr<const Palette> palette = randomPalette(engine, 9);
        const ColorHistogram histogram = randomHistogram(engine, 40);
        for (std::size_t count = 1; count < 6; ++count)
        {
            const osg::ref_ptr<const Palette> chosen = chooseColors(*palette, histogram, count);
            ASSERT_EQ(chosen->getColors().size(), count);
            const double error = errorOf(colorsOf(*chosen), histogram.getShares());
            const double least = leastError(*palette, histogram.getShares(), count);
            numBest += error < least * 1.000001 ? 1 : 0;
            ++numCases;
            ASSERT_LT(error, 1.15 * least) << round << ' ' << count;
        }
    }
    // Exchanging one colour at a time does not find the best choice.
    EXPECT_GE(numBest, numCases * 95 / 100);
}

TEST(ColorChoice, IsBetterThanTheMostFrequentColours)
{
    const osg::ref_ptr<const Palette> palette = createPalette({{0, "darkest grey", {82, 82, 82}},
                                                               {1, "dark grey", {107, 107, 107}},
                                                               {2, "light grey", {132, 132, 132}},
                                                               {3, "lightest grey", {157, 157, 157}},
                                                               {4, "red", {180, 0, 0}},
                                                               {5, "yellow", {250, 200, 10}},
                                                               {6, "blue", {30, 90, 168}}});
    // Many shades of grey hide a little red, yellow and blue.
    ColorHistogram histogram;
    for (int shade = 70; shade < 170; ++shade)
        histogram.add(
            {static_cast<std::uint8_t>(shade), static_cast<std::uint8_t>(shade), static_cast<std::uint8_t>(shade)},
            10.0);
    for (const Color& color : {Color{190, 10, 10}, Color{250, 200, 10}, Color{20, 90, 170}})
        histogram.add(color, 60.0);
    const std::vector<ColorShare> shares = histogram.getShares();
    std::map<std::size_t, double> weights;
    for (const ColorShare& share : shares)
        weights[palette->findNearest(share.color)] += share.weight;
    std::vector<std::pair<double, std::size_t>> byWeight;
    for (const auto& [index, weight] : weights)
        byWeight.emplace_back(-weight, index);
    std::sort(byWeight.begin(), byWeight.end());
    ASSERT_GT(byWeight.size(), 5u);
    std::vector<PaletteColor> frequent;
    for (std::size_t place = 0; place < 5; ++place)
        frequent.push_back(palette->getColors()[byWeight[place].second]);
    const osg::ref_ptr<const Palette> chosen = chooseColors(*palette, histogram, 5);
    EXPECT_LT(errorOf(colorsOf(*chosen), shares), 0.5 * errorOf(frequent, shares));
}

TEST(ColorChoice, AnExchangeMendsAGreedyChoice)
{
    // The first colour taken is the middle one; the best two are those at the ends.
    const osg::ref_ptr<const Palette> palette =
        createPalette({{0, "black", {40, 40, 40}}, {1, "grey", {110, 110, 110}}, {2, "white", {200, 200, 200}}});
    ColorHistogram histogram;
    histogram.add({40, 40, 40}, 10.0);
    histogram.add({200, 200, 200}, 10.0);
    const osg::ref_ptr<const Palette> chosen = chooseColors(*palette, histogram, 2);
    EXPECT_EQ(chosen->getColors()[0].name, "black");
    EXPECT_EQ(chosen->getColors()[1].name, "white");
}

TEST(ColorChoice, WeightsDecide)
{
    const osg::ref_ptr<const Palette> palette =
        createPalette({{0, "red", {180, 0, 0}}, {1, "green", {0, 133, 43}}, {2, "blue", {30, 90, 168}}});
    const auto choose = [&](double red, double green, double blue)
    {
        ColorHistogram histogram;
        histogram.add({180, 0, 0}, red);
        histogram.add({0, 133, 43}, green);
        histogram.add({30, 90, 168}, blue);
        return chooseColors(*palette, histogram, 1)->getColors()[0].name;
    };
    EXPECT_EQ(choose(10, 1, 1), "red");
    EXPECT_EQ(choose(1, 10, 1), "green");
    EXPECT_EQ(choose(1, 1, 10), "blue");
}

TEST(ColorChoice, VividBlueAndYellowKeepTheirNames)
{
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read("ldraw", error);
    ColorHistogram histogram;
    histogram.add({0, 0, 255}, 10.0);
    histogram.add({255, 255, 0}, 10.0);
    const osg::ref_ptr<const Palette> chosen = chooseColors(*palette, histogram, 2);
    EXPECT_EQ(chosen->getColors()[0].name, "Blue");
    EXPECT_EQ(chosen->getColors()[1].name, "Yellow");
}

TEST(ColorChoice, KeepsThePaletteIfItHasNoMoreColours)
{
    std::mt19937 engine(2);
    const osg::ref_ptr<const Palette> palette = randomPalette(engine, 10);
    EXPECT_EQ(chooseColors(*palette, randomHistogram(engine, 5), 10), palette);
    EXPECT_EQ(chooseColors(*palette, randomHistogram(engine, 5), 255), palette);
}

TEST(ColorChoice, EqualChoicesShareAPalette)
{
    // Creating tables is expensive, and a source that changes in every frame usually needs the same colours.
    std::mt19937 engine(4);
    const osg::ref_ptr<const Palette> palette = randomPalette(engine, 10);
    const ColorHistogram histogram = randomHistogram(engine, 20);
    EXPECT_EQ(chooseColors(*palette, histogram, 4), chooseColors(*palette, histogram, 4));
    EXPECT_NE(chooseColors(*palette, histogram, 4), chooseColors(*palette, histogram, 5));
}

TEST(ColorChoice, NothingToShowAndFewerColoursThanWantedAreNoError)
{
    std::mt19937 engine(2);
    const osg::ref_ptr<const Palette> palette = randomPalette(engine, 10);
    EXPECT_EQ(chooseColors(*palette, ColorHistogram(), 3)->getColors().size(), 3u);
    ColorHistogram one;
    one.add({1, 2, 3}, 1.0);
    EXPECT_EQ(chooseColors(*palette, one, 9)->getColors().size(), 9u);
}

TEST(ColorHistogram, AddsEqualColoursAndJoinsSimilarOnes)
{
    ColorHistogram histogram;
    histogram.add({10, 20, 30}, 1.5);
    histogram.add({10, 20, 30}, 0.5);
    histogram.add({14, 20, 30}, 2.0);
    histogram.add({255, 255, 255}, 1.0);
    histogram.add({0, 255, 0}, 0.0);
    EXPECT_EQ(histogram.getShares(), (std::vector<ColorShare>{{{12, 20, 30}, 4.0}, {{255, 255, 255}, 1.0}}));
}

} // namespace

} // namespace osgLego
