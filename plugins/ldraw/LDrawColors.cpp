#include "LDrawColors.h"

#include <osgLego/Palette.h>

namespace osgLego
{

LDrawColors::LDrawColors()
{
    for (const PaletteColor& color : Palette::getKnownColors())
        _colors[color.code] = color.color;
}

void LDrawColors::add(const std::vector<LDrawColorDefinition>& definitions)
{
    for (const LDrawColorDefinition& definition : definitions)
        if (definition.code != PaletteColor::BLACK) _colors[definition.code] = definition.color;
}

std::int32_t LDrawColors::toDirect(const Color& color)
{
    return FIRST_DIRECT + (color[0] << 16) + (color[1] << 8) + color[2];
}

std::optional<LDrawColors::Color> LDrawColors::find(std::int32_t value) const
{
    const auto byteOf = [value](int shift) { return static_cast<std::uint8_t>(value >> shift); };
    if (isDirect(value)) return Color{byteOf(16), byteOf(8), byteOf(0)};
    const auto found = _colors.find(value);
    if (found == _colors.end()) return std::nullopt;
    return found->second;
}

} // namespace osgLego
