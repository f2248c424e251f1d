#include <osgLego/Palette.h>
#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/Dither.h>

#include <Palettes.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

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

TEST(Dither, ThresholdsFollowTheSequenceR3)
{
    // In its closed form: the fractions of multiples of the inverse powers of a number g.
    double g = 1.0;
    for (int iteration = 0; iteration < 100; ++iteration)
        g = std::pow(g + 1.0, 0.25);
    for (unsigned int x = 0; x < 2560; x += 97)
        for (unsigned int y = 0; y < 2560; y += 101)
            for (unsigned int z = 0; z < 2560; z += 103)
            {
                const double value = x / g + y / (g * g) + z / (g * g * g);
                ASSERT_NEAR(Dither::thresholdAt(x, y, z) + 0.5, 256.0 * (value - std::floor(value)), 0.51)
                    << x << ' ' << y << ' ' << z;
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

/** How well the cells of even surfaces show the colours of the surfaces. */
struct Imitation
{
    double plainError = 0.0;     // of the nearest colours
    double error = 0.0;          // of the means of the cells
    double lightnessError = 0.0; // of these means, positive if they are too light
};

/** Imitate colours between two of a palette, on planes across all axes, and take the means over the surfaces. Light of
 * neighbouring bricks adds up in the eye, so that means are those of linear light. */
Imitation imitate(const Palette& palette, std::mt19937& engine, int numColors)
{
    Imitation imitation;
    const auto colors = palette.getColors();
    for (int number = 0; number < numColors; ++number)
    {
        const Color& first = colors[engine() % colors.size()].color;
        const Color& second = colors[engine() % colors.size()].color;
        const double share = std::uniform_real_distribution<double>(0.0, 1.0)(engine);
        Color color{};
        for (std::size_t channel = 0; channel < 3; ++channel)
            color[channel] = static_cast<std::uint8_t>(std::lround(std::lerp(first[channel], second[channel], share)));
        const glm::dvec3 place = toCieLab(color);
        glm::dvec3 sum(0.0);
        for (int cell = 0; cell < 256; ++cell)
        {
            const Cell inPlane = cellOn(static_cast<std::size_t>(number % 3), cell % 16, cell / 16);
            const Color& brick = colors[palette.findDithered(color, inPlane)].color;
            sum += glm::dvec3(toLinear(brick[0]), toLinear(brick[1]), toLinear(brick[2]));
        }
        const glm::dvec3 mean = linearToCieLab(sum / 256.0);
        imitation.plainError += ciede2000(place, toCieLab(colors[palette.findNearest(color)].color)) / numColors;
        imitation.error += ciede2000(place, mean) / numColors;
        imitation.lightnessError += (mean.x - place.x) / numColors;
    }
    return imitation;
}

TEST(Dither, TheMeanOfAnEvenSurfaceIsNearerToItsColourThanTheNearestColour)
{
    std::string error;
    std::mt19937 engine(7);
    const Imitation imitation = imitate(*Palette::read("ldraw", error), engine, 600);
    EXPECT_LT(imitation.error, 0.3 * imitation.plainError);
    EXPECT_NEAR(imitation.lightnessError, 0.0, 0.5); // 1 is just noticeable
}

TEST(Dither, TheMeanIsNearerWithPalettesOfAnySize)
{
    std::mt19937 engine(8);
    for (const std::size_t count : {6, 16, 40, 120})
    {
        Imitation sum;
        for (int round = 0; round < 4; ++round)
        {
            std::vector<PaletteColor> colors(count);
            for (PaletteColor& color : colors)
                for (std::uint8_t& channel : color.color)
                    channel = static_cast<std::uint8_t>(engine());
            const Imitation imitation = imitate(*createPalette(colors), engine, 100);
            sum.error += imitation.error;
            sum.plainError += imitation.plainError;
            sum.lightnessError += imitation.lightnessError / 4.0;
        }
        EXPECT_LT(sum.error, 0.5 * sum.plainError) << count;
        EXPECT_NEAR(sum.lightnessError, 0.0, 1.2) << count;
    }
}

TEST(Dither, BlackAndWhiteImitateGrey)
{
    const osg::ref_ptr<const Palette> palette = createPalette({{0, "black", {0, 0, 0}}, {1, "white", {255, 255, 255}}});
    int numWhite = 0;
    for (int cell = 0; cell < 256; ++cell)
        numWhite += static_cast<int>(palette->findDithered({110, 110, 110}, cellOn(0, cell % 16, cell / 16)));
    // 110 is 15.6 % of white in linear light: (110 / 255 + 0.055) / 1.055 to the power of 2.4.
    EXPECT_NEAR(numWhite, 0.156 * 256, 3);
}

TEST(Dither, ThePatternDependsOnAllCoordinates)
{
    const osg::ref_ptr<const Palette> palette = createPalette({{0, "black", {0, 0, 0}}, {1, "white", {255, 255, 255}}});
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        int numWhite = 0;
        for (int step = 0; step < 64; ++step)
        {
            Cell cell{5, 6, 7};
            cell[axis] = static_cast<std::uint16_t>(step);
            numWhite += static_cast<int>(palette->findDithered({188, 188, 188}, cell)); // half of white
        }
        EXPECT_NEAR(numWhite, 32, 4) << axis;
    }
}

} // namespace

} // namespace osgLego
