#pragma once

#include <osgLego/Part.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace osgLego
{

/** A colour of plastic, and the sizes of parts that were made in it. */
struct PaletteColor
{
    static constexpr std::uint16_t ALL_SIZES = (1u << 11) - 1;
    /** LDraw's code of black, which LDConfig.ldr shows as a blue grey. The colour of the plastic, in
     * data/ldraw-solid-colours.csv, takes the place of such definitions. */
    static constexpr std::int32_t BLACK = 0;

    std::int32_t code = Part::NO_CODE;   //!< LDraw's
    std::string name;                    //!< such as "Dark_Turquoise"
    std::array<std::uint8_t, 3> color{}; //!< red, green, blue (sRGB)
    std::int32_t brickLink = -1;         //!< BrickLink's number; -1 if it is not known
    std::uint16_t bricks = ALL_SIZES;    //!< bit i is set if a brick of size PART_SIZES[i] was ever made
    std::uint16_t plates = ALL_SIZES;    //!< likewise for plates

    bool operator==(const PaletteColor&) const = default;
};

/** Two colours of a palette whose bricks imitate a colour between them. */
struct PaletteMixture
{
    std::uint8_t first = 0;  //!< index of a colour
    std::uint8_t second = 0; //!< index of the lighter colour, or the same
    std::uint8_t share = 0;  //!< bricks of the second colour out of 256

    bool operator==(const PaletteMixture&) const = default;
};

/** The sizes of palettes and of the tables by which they find the nearest colour. */
struct PaletteLimits
{
    static constexpr int TABLE_SIDE = 64;
    static constexpr std::size_t MAXIMUM_COLORS = 255;
};

} // namespace osgLego
