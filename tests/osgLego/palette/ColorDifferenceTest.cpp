#include <osgLego/palette/ColorDifference.h>

#include <array>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

// Sharma, Wu and Dalal (2005), table 1: L*, a* and b* of two colours, and their difference.
constexpr std::array<std::array<double, 7>, 34> PUBLISHED{{
    {50.0000, 2.6772, -79.7751, 50.0000, 0.0000, -82.7485, 2.0425},
    {50.0000, 3.1571, -77.2803, 50.0000, 0.0000, -82.7485, 2.8615},
    {50.0000, 2.8361, -74.0200, 50.0000, 0.0000, -82.7485, 3.4412},
    {50.0000, -1.3802, -84.2814, 50.0000, 0.0000, -82.7485, 1.0000},
    {50.0000, -1.1848, -84.8006, 50.0000, 0.0000, -82.7485, 1.0000},
    {50.0000, -0.9009, -85.5211, 50.0000, 0.0000, -82.7485, 1.0000},
    {50.0000, 0.0000, 0.0000, 50.0000, -1.0000, 2.0000, 2.3669},
    {50.0000, -1.0000, 2.0000, 50.0000, 0.0000, 0.0000, 2.3669},
    {50.0000, 2.4900, -0.0010, 50.0000, -2.4900, 0.0009, 7.1792},
    {50.0000, 2.4900, -0.0010, 50.0000, -2.4900, 0.0010, 7.1792},
    {50.0000, 2.4900, -0.0010, 50.0000, -2.4900, 0.0011, 7.2195},
    {50.0000, 2.4900, -0.0010, 50.0000, -2.4900, 0.0012, 7.2195},
    {50.0000, -0.0010, 2.4900, 50.0000, 0.0009, -2.4900, 4.8045},
    {50.0000, -0.0010, 2.4900, 50.0000, 0.0010, -2.4900, 4.8045},
    {50.0000, -0.0010, 2.4900, 50.0000, 0.0011, -2.4900, 4.7461},
    {50.0000, 2.5000, 0.0000, 50.0000, 0.0000, -2.5000, 4.3065},
    {50.0000, 2.5000, 0.0000, 73.0000, 25.0000, -18.0000, 27.1492},
    {50.0000, 2.5000, 0.0000, 61.0000, -5.0000, 29.0000, 22.8977},
    {50.0000, 2.5000, 0.0000, 56.0000, -27.0000, -3.0000, 31.9030},
    {50.0000, 2.5000, 0.0000, 58.0000, 24.0000, 15.0000, 19.4535},
    {50.0000, 2.5000, 0.0000, 50.0000, 3.1736, 0.5854, 1.0000},
    {50.0000, 2.5000, 0.0000, 50.0000, 3.2972, 0.0000, 1.0000},
    {50.0000, 2.5000, 0.0000, 50.0000, 1.8634, 0.5757, 1.0000},
    {50.0000, 2.5000, 0.0000, 50.0000, 3.2592, 0.3350, 1.0000},
    {60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644},
    {63.0109, -31.0961, -5.8663, 62.8187, -29.7946, -4.0864, 1.2630},
    {61.2901, 3.7196, -5.3901, 61.4292, 2.2480, -4.9620, 1.8731},
    {35.0831, -44.1164, 3.7933, 35.0232, -40.0716, 1.5901, 1.8645},
    {22.7233, 20.0904, -46.6940, 23.0331, 14.9730, -42.5619, 2.0373},
    {36.4612, 47.8580, 18.3852, 36.2715, 50.5065, 21.2231, 1.4146},
    {90.8027, -2.0831, 1.4410, 91.1528, -1.6435, 0.0447, 1.4441},
    {90.9257, -0.5406, -0.9208, 88.6381, -0.8985, -0.7239, 1.5381},
    {6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286, 0.6377},
    {2.0776, 0.0795, -1.1350, 0.9033, -0.0636, -0.5514, 0.9082},
}};

/** The formula as it is printed, with angles in degrees. */
double differenceByAngles(const glm::dvec3& first, const glm::dvec3& second)
{
    constexpr double DEGREE = 3.14159265358979323846 / 180.0;
    const auto cosine = [](double angle) { return std::cos(angle * DEGREE); };
    const auto sine = [](double angle) { return std::sin(angle * DEGREE); };
    const auto share = [](double chroma)
    { return std::sqrt(std::pow(chroma, 7) / (std::pow(chroma, 7) + std::pow(25.0, 7))); };
    const double g = 0.5 * (1.0 - share(0.5 * (std::hypot(first.y, first.z) + std::hypot(second.y, second.z))));
    const auto hueOf = [&](const glm::dvec3& color)
    { return std::fmod(std::atan2(color.z, (1.0 + g) * color.y) / DEGREE + 360.0, 360.0); };
    const double c1 = std::hypot((1.0 + g) * first.y, first.z);
    const double c2 = std::hypot((1.0 + g) * second.y, second.z);
    const double h1 = hueOf(first);
    const double h2 = hueOf(second);
    double dh = h2 - h1;
    double h = 0.5 * (h1 + h2);
    if (std::abs(dh) > 180.0)
    {
        dh -= dh > 0.0 ? 360.0 : -360.0;
        h += h < 180.0 ? 180.0 : -180.0;
    }
    const double l = 0.5 * (first.x + second.x) - 50.0;
    const double c = 0.5 * (c1 + c2);
    const double t = 1.0 - 0.17 * cosine(h - 30.0) + 0.24 * cosine(2.0 * h) + 0.32 * cosine(3.0 * h + 6.0) -
                     0.2 * cosine(4.0 * h - 63.0);
    const double dL = (second.x - first.x) / (1.0 + 0.015 * l * l / std::sqrt(20.0 + l * l));
    const double dC = (c2 - c1) / (1.0 + 0.045 * c);
    const double dH = 2.0 * std::sqrt(c1 * c2) * sine(0.5 * dh) / (1.0 + 0.015 * c * t);
    const double rT = -2.0 * share(c) * sine(60.0 * std::exp(-std::pow((h - 275.0) / 25.0, 2)));
    return std::sqrt(dL * dL + dC * dC + dH * dH + rT * dC * dH);
}

TEST(ColorDifference, HasThePublishedValues)
{
    for (const auto& [l1, a1, b1, l2, a2, b2, expected] : PUBLISHED)
    {
        // The published values have four decimals.
        EXPECT_NEAR(ciede2000({l1, a1, b1}, {l2, a2, b2}), expected, 5e-5);
        EXPECT_NEAR(ciede2000({l2, a2, b2}, {l1, a1, b1}), expected, 5e-5);
    }
}

TEST(ColorDifference, IsThatOfTheFormulaWithAngles)
{
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> lightness(0.0, 100.0);
    for (const double extent : {1.0, 10.0, 100.0})
    {
        std::uniform_real_distribution<double> place(-extent, extent);
        for (int number = 0; number < 20000; ++number)
        {
            const glm::dvec3 first(lightness(engine), place(engine), place(engine));
            const glm::dvec3 second(lightness(engine), place(engine), place(engine));
            ASSERT_NEAR(ciede2000(first, second), differenceByAngles(first, second), 1e-5) << number << ' ' << extent;
        }
    }
}

TEST(ColorDifference, OfEqualColoursIsZero)
{
    for (const glm::dvec3& color : {glm::dvec3(0.0), glm::dvec3(50.0, 0.0, 0.0), glm::dvec3(30.0, 70.0, -40.0)})
        EXPECT_EQ(ciede2000(color, color), 0.0);
}

TEST(ColorDifference, IsNeverLessThanThatOfLightness)
{
    std::mt19937 engine(2);
    std::uniform_real_distribution<double> lightness(0.0, 100.0);
    std::uniform_real_distribution<double> place(-90.0, 90.0);
    for (int number = 0; number < 20000; ++number)
    {
        const glm::dvec3 first(lightness(engine), place(engine), place(engine));
        const glm::dvec3 second(lightness(engine), place(engine), place(engine));
        ASSERT_LE(lightnessDifference(first, second), ciede2000(first, second) + 1e-9);
        // Greys differ by nothing else.
        const glm::dvec3 grey(first.x, 0.0, 0.0);
        const glm::dvec3 otherGrey(second.x, 0.0, 0.0);
        ASSERT_NEAR(lightnessDifference(grey, otherGrey), ciede2000(grey, otherGrey), 1e-9);
    }
}

TEST(ColorDifference, TheScaleGivesThatOfSmallDifferences)
{
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> lightness(0.0, 100.0);
    std::uniform_real_distribution<double> place(-60.0, 60.0);
    std::uniform_real_distribution<double> step(-0.001, 0.001);
    for (int number = 0; number < 5000; ++number)
    {
        const glm::dvec3 color(lightness(engine), place(engine), place(engine));
        const glm::dvec3 difference(step(engine), step(engine), step(engine));
        // In blue, chroma and hue interact, which the scale ignores.
        if (color.z < 0.0 && color.y > -40.0) continue;
        const double expected = ciede2000(color, color + difference);
        ASSERT_NEAR(glm::length(ciede2000Scale(color) * difference), expected, 0.1 * expected + 1e-5)
            << color.x << ' ' << color.y << ' ' << color.z;
    }
    // For lightness alone, and for greys, there is no other effect.
    for (const double middle : {5.0, 50.0, 90.0})
    {
        const glm::dvec3 grey(middle, 0.0, 0.0);
        for (const glm::dvec3& difference :
             {glm::dvec3(0.01, 0.0, 0.0), glm::dvec3(0.0, 0.01, 0.0), glm::dvec3(0.0, 0.0, 0.01)})
            EXPECT_NEAR(glm::length(ciede2000Scale(grey) * difference), ciede2000(grey, grey + difference), 1e-4);
    }
}

} // namespace

} // namespace osgLego
