#include <osgLego/Palette.h>
#include <osgLego/palette/Dither.h>
#include <osgLego/palette/Oklab.h>

#include <Palettes.h>

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;
using Cell = std::array<std::uint16_t, 3>;

/** A cell of a plane across an axis. */
Cell cellOn(std::size_t axis, int column, int row)
{
    Cell cell{};
    cell[axis] = 11;
    cell[(axis + 1) % 3] = static_cast<std::uint16_t>(column);
    cell[(axis + 2) % 3] = static_cast<std::uint16_t>(row);
    return cell;
}

TEST(Dither, ThresholdsAreSpreadEvenlyOverEveryPlane)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 900; corner += 100)
        {
            // 256 cells have a sixteenth of all thresholds in each sixteenth of their range, more or less.
            std::array<int, 16> counts{};
            for (int row = 0; row < 16; ++row)
                for (int column = 0; column < 16; ++column)
                {
                    const Cell cell = cellOn(axis, corner + column, corner + row);
                    ++counts[Dither::thresholdAt(cell[0], cell[1], cell[2]) / 16];
                }
            for (const int count : counts)
                EXPECT_NEAR(count, 16, 6) << axis << ' ' << corner;
        }
}

TEST(Dither, NeighboursHaveDifferentThresholds)
{
    const auto at = [](int x, int y, int z)
    {
        return static_cast<int>(
            Dither::thresholdAt(static_cast<unsigned>(x), static_cast<unsigned>(y), static_cast<unsigned>(z)));
    };
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y)
            for (int z = 0; z < 8; ++z)
                for (const int other : {at(x + 1, y, z), at(x, y + 1, z), at(x, y, z + 1)})
                    EXPECT_GT(std::abs(at(x, y, z) - other), 40);
}

TEST(Dither, OffsetsAreOfBothSignsUpToHalfTheAmplitudeAndStayInRange)
{
    EXPECT_EQ(Dither::offsetChannel(100, 64, 0), 68);
    EXPECT_EQ(Dither::offsetChannel(100, 64, 255), 132);
    EXPECT_EQ(Dither::offsetChannel(100, 64, 127), 100);
    EXPECT_EQ(Dither::offsetChannel(100, 64, 128), 100);
    EXPECT_EQ(Dither::offsetChannel(100, 0, 255), 100);
    EXPECT_EQ(Dither::offsetChannel(0, 255, 0), 0);
    EXPECT_EQ(Dither::offsetChannel(255, 255, 255), 255);
    EXPECT_EQ(Dither::offsetChannel(0, 255, 255), 127);
}

TEST(Dither, OffsetsAreAtMostFourTimesTheDistanceToTheNearestColour)
{
    EXPECT_EQ(Dither::limitOffset(64, 3), 12);
    EXPECT_EQ(Dither::limitOffset(64, 16), 64);
    EXPECT_EQ(Dither::limitOffset(64, 200), 64);
    // The channel with the largest distance counts: 4 x 5 levels limit the offset to 10 on each side.
    for (int cell = 0; cell < 256; ++cell)
        for (const std::uint8_t channel :
             Dither::dithered({100, 100, 100}, {100, 98, 105}, cellOn(0, cell % 16, cell / 16), 255))
            EXPECT_NEAR(channel, 100, 10);
}

TEST(Dither, EachChannelFollowsTheSequenceAlongOtherAxes)
{
    // The sequence R3 in its closed form: the fractions of multiples of the inverse powers of a number g.
    double g = 1.0;
    for (int iteration = 0; iteration < 100; ++iteration)
        g = std::pow(g + 1.0, 0.25);
    for (int x = 0; x < 2560; x += 97)
        for (int y = 0; y < 2560; y += 101)
            for (int z = 0; z < 2560; z += 103)
            {
                const std::array<int, 3> cell{x, y, z};
                const Color color = Dither::dithered(
                    {128, 128, 128}, {0, 0, 0},
                    {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(z)}, 250);
                for (std::size_t channel = 0; channel < 3; ++channel)
                {
                    const double value =
                        cell[channel] / g + cell[(channel + 1) % 3] / (g * g) + cell[(channel + 2) % 3] / (g * g * g);
                    ASSERT_NEAR(color[channel], 128.0 + 250.0 * (value - std::floor(value) - 0.5), 1.5)
                        << x << ' ' << y << ' ' << z;
                }
            }
}

TEST(Dither, ColoursOfThePaletteStayPlain)
{
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read("ldraw", error);
    for (std::size_t index = 0; index < palette->getColors().size(); ++index)
        for (int cell = 0; cell < 256; ++cell)
            ASSERT_EQ(palette->findDithered(palette->getColors()[index].color, cellOn(2, cell % 16, cell / 16)), index);
}

TEST(Dither, TheMeanOfAnEvenSurfaceIsNearerToItsColourThanTheNearestColour)
{
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read("ldraw", error);
    double plainError = 0.0;
    double ditheredError = 0.0;
    const std::array<Color, 6> between{Color{126, 126, 126}, {210, 60, 20},  {120, 60, 130},
                                       {150, 150, 60},       {60, 110, 110}, {200, 205, 210}};
    for (const Color& color : between)
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const auto linearOf = [](const Color& from)
            { return glm::dvec3(toLinear(from[0]), toLinear(from[1]), toLinear(from[2])); };
            glm::dvec3 sum(0.0);
            for (int cell = 0; cell < 256; ++cell)
                sum += linearOf(
                    palette->getColors()[palette->findDithered(color, cellOn(axis, cell % 16, cell / 16))].color);
            const Color& nearest = palette->getColors()[palette->findNearest(color)].color;
            plainError += glm::distance(toOklab(color), toOklab(nearest));
            ditheredError += glm::distance(toOklab(color), linearToOklab(sum / 256.0));
        }
    EXPECT_LT(ditheredError, 0.5 * plainError);
}

TEST(Dither, BlackAndWhiteImitateGrey)
{
    const osg::ref_ptr<const Palette> palette = createPalette({{0, "black", {0, 0, 0}}, {1, "white", {255, 255, 255}}});
    int numWhite = 0;
    for (int cell = 0; cell < 256; ++cell)
        numWhite += static_cast<int>(palette->findDithered({110, 110, 110}, cellOn(0, cell % 16, cell / 16)));
    EXPECT_GT(numWhite, 64);
    EXPECT_LT(numWhite, 192);
}

TEST(Dither, TheAmplitudeFollowsTheNumberOfColours)
{
    const auto amplitudeOf = [](std::size_t count)
    { return createPalette(std::vector<PaletteColor>(count))->getDitherAmplitude(); };
    EXPECT_EQ(amplitudeOf(8), 102); // 0.8 x 256 / 2
    EXPECT_EQ(amplitudeOf(64), 51); // 0.8 x 256 / 4
    EXPECT_LE(amplitudeOf(1), 255);
}

} // namespace

} // namespace osgLego
