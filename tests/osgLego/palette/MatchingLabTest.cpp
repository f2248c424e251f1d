#include <osgLego/Palette.h>
#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/MatchingLab.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

double hueOfPlace(const glm::dvec3& place)
{
    constexpr double DEGREES = 57.29577951308232;
    const double hue = DEGREES * std::atan2(place.z, place.y);
    return hue < 0.0 ? hue + 360.0 : hue;
}

double chromaAt(const glm::dvec3& place)
{
    return std::hypot(place.y, place.z);
}

/** A colour of the hue circle of displays. @param angle 0 for red, 1 for yellow, up to 6. */
Color vividColor(double angle)
{
    const auto channelAt = [&](double middle)
    {
        const double distance = std::abs(std::remainder(angle - middle, 6.0));
        return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(2.0 - distance, 0.0, 1.0)));
    };
    return {channelAt(0.0), channelAt(2.0), channelAt(4.0)};
}

TEST(MatchingLab, BlueHasTheHueOfOkLab)
{
    // CSS Color 4 has oklch(0.452 0.313 264.05) for blue.
    for (const std::uint8_t channel : std::array<std::uint8_t, 3>{255, 190, 128})
    {
        const Color color{0, 0, channel};
        const glm::dvec3 place = toMatchingLab(color);
        EXPECT_NEAR(hueOfPlace(place), 264.05 + 20.0, 0.1);
        EXPECT_NEAR(chromaAt(place), chromaAt(toCieLab(color)), 1e-9);
        EXPECT_EQ(place.x, toCieLab(color).x);
    }
}

TEST(MatchingLab, YellowIsDarkerAndRedder)
{
    const glm::dvec3 place = toCieLab({255, 255, 0});
    const glm::dvec3 moved = toMatchingLab({255, 255, 0});
    EXPECT_NEAR(moved.x, place.x - 10.0, 1e-9);
    EXPECT_NEAR(hueOfPlace(moved), hueOfPlace(place) - 10.0, 1e-9);
    EXPECT_NEAR(chromaAt(moved), chromaAt(place), 1e-9);
}

TEST(MatchingLab, OtherColoursKeepTheirPlaces)
{
    for (const Color& color : {Color{255, 0, 0}, Color{0, 255, 0}, Color{0, 255, 255}, Color{255, 0, 255},
                               Color{255, 128, 0}, Color{128, 0, 128}, Color{90, 100, 130}, Color{255, 255, 150},
                               Color{0, 0, 0}, Color{77, 77, 77}, Color{255, 255, 255}})
        EXPECT_EQ(toMatchingLab(color), toCieLab(color)) << +color[0] << ' ' << +color[1] << ' ' << +color[2];
}

TEST(MatchingLab, PlasticsKeepTheirPlaces)
{
    std::string error;
    for (const PaletteColor& color : Palette::read("ldraw", error)->getColors())
        EXPECT_EQ(toMatchingLab(color.color), toCieLab(color.color)) << color.name;
}

TEST(MatchingLab, SimilarColoursHaveSimilarPlaces)
{
    constexpr int NUM_STEPS = 600;
    for (const double strength : {1.0, 0.7, 0.4, 0.1})
        for (int step = 0; step < NUM_STEPS; ++step)
        {
            const auto placeAt = [&](int number)
            { return linearToMatchingLab(strength * toLinear(vividColor(6.0 * number / NUM_STEPS))); };
            ASSERT_LT(ciede2000(placeAt(step), placeAt(step + 1)), 2.5) << strength << ' ' << step;
        }
}

} // namespace

} // namespace osgLego
