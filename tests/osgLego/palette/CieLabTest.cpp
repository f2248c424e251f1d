#include <osgLego/palette/CieLab.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(CieLab, HasThePublishedValues)
{
    // Of the primaries of sRGB and of white; Lindbloom's calculator gives them to four decimals.
    const auto expectNear = [](const glm::dvec3& actual, const glm::dvec3& expected)
    { EXPECT_LT(glm::distance(actual, expected), 1e-3) << actual.x << ' ' << actual.y << ' ' << actual.z; };
    expectNear(toCieLab({255, 255, 255}), {100.0, 0.0, 0.0});
    expectNear(toCieLab({255, 0, 0}), {53.2408, 80.0925, 67.2032});
    expectNear(toCieLab({0, 255, 0}), {87.7347, -86.1827, 83.1793});
    expectNear(toCieLab({0, 0, 255}), {32.2970, 79.1875, -107.8602});
    expectNear(toCieLab({0, 0, 0}), {0.0, 0.0, 0.0});
}

TEST(CieLab, GreysHaveNoChroma)
{
    for (int level = 0; level < 256; ++level)
    {
        const auto channel = static_cast<std::uint8_t>(level);
        const glm::dvec3 place = toCieLab({channel, channel, channel});
        EXPECT_NEAR(place.y, 0.0, 1e-9);
        EXPECT_NEAR(place.z, 0.0, 1e-9);
    }
}

TEST(CieLab, DarkColoursAreOnTheStraightPartOfTheCurve)
{
    // CIE 15: L* = (29/3)^3 Y below Y = (6/29)^3, and sRGB is linear light / 12.92 there.
    EXPECT_NEAR(toCieLab({5, 5, 5}).x, 24389.0 / 27.0 * (5.0 / 255.0 / 12.92), 1e-6);
    EXPECT_NEAR(toLinear(10), 10.0 / 255.0 / 12.92, 1e-12);
}

TEST(CieLab, DerivativesAreThoseOfSmallSteps)
{
    constexpr double STEP = 1e-6;
    for (const glm::dvec3& color : {glm::dvec3(0.001, 0.002, 0.0005), glm::dvec3(0.2, 0.5, 0.1), glm::dvec3(1.0)})
        for (int channel = 0; channel < 3; ++channel)
        {
            glm::dvec3 step(0.0);
            step[channel] = STEP;
            const glm::dvec3 expected = (linearToCieLab(color + step) - linearToCieLab(color - step)) / (2.0 * STEP);
            EXPECT_LT(glm::distance(cieLabDerivatives(color)[channel], expected), 1e-5 * glm::length(expected))
                << channel;
        }
}

} // namespace

} // namespace osgLego
