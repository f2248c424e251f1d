#pragma once

#include "LDrawDocument.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace osgLego
{

/** The colours that belong to the codes in LDraw's files: those that the library knows, and definitions of files. */
class LDrawColors
{
public:
    using Color = std::array<std::uint8_t, 3>; //!< red, green, blue (sRGB)

    static constexpr Color UNKNOWN{127, 127, 127}; //!< shown for the main colour, and for codes without a colour
    static constexpr std::int32_t FIRST_DIRECT = 0x2000000; //!< 0x2RRGGBB, or 0x3RRGGBB for transparent ones

    LDrawColors();

    /** Add definitions, which replace earlier ones, except that of black: see PaletteColor::BLACK. */
    void add(const std::vector<LDrawColorDefinition>& definitions);

    static bool isDirect(std::int32_t value) { return value >= FIRST_DIRECT && value < 2 * FIRST_DIRECT; }
    static std::int32_t toDirect(const Color& color);

    /** The colour of a code or of a direct colour; nothing if it is not known. */
    std::optional<Color> find(std::int32_t value) const;

private:
    std::map<std::int32_t, Color> _colors;
};

} // namespace osgLego
