#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/KnownColors.h>
#include <osgLego/polygonization/FadedColor.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

TEST(FadedColor, NoFadedColorOfTheDefaultPaletteLooksLikeARealOne)
{
    constexpr std::array<double, 3> FADED{FadedColor::FADED_RED, FadedColor::FADED_GREEN, FadedColor::FADED_BLUE};
    constexpr double DISTINCT = 6.0; // CIEDE2000; 1 is just noticeable side by side
    const std::vector<PaletteColor> colors = selectDefaultColors();
    ASSERT_FALSE(colors.empty());
    for (const PaletteColor& own : colors)
    {
        std::array<std::uint8_t, 3> faded{};
        for (std::size_t channel = 0; channel < faded.size(); ++channel)
            faded[channel] = static_cast<std::uint8_t>(std::lround((1.0 - FadedColor::FADING) * own.color[channel] +
                                                                   FadedColor::FADING * 255.0 * FADED[channel]));
        for (const PaletteColor& real : colors)
            EXPECT_GE(ciede2000(toCieLab(faded), toCieLab(real.color)), DISTINCT) << own.name << ", " << real.name;
    }
}

} // namespace osgLego::test
