#pragma once

#include <osgLego/PaletteColor.h>

#include <string>
#include <string_view>
#include <vector>

namespace osgLego
{

class TextLines;

/** Reads the values of colours in one line of a text, and adds up the colours that are found.
 *
 * Every function that returns a string returns one sentence that names the line and the bad value, or nothing if there
 * is no error.
 */
class ColorText
{
public:
    static constexpr std::size_t LONGEST_LINE = 1000;
    static constexpr std::size_t LONGEST_NAME = 100;
    // In place of a colour, these mean that of the part around it and that of its edges.
    static constexpr std::int32_t MAIN_COLOR = 16;
    static constexpr std::int32_t EDGE_COLOR = 24;

    /** @param lines must outlive this object. */
    explicit ColorText(const TextLines& lines) : _lines(lines) {}

    std::string checkLength() const;
    std::string readName(std::string_view text, std::string& name) const;
    std::string readCode(std::string_view text, std::int32_t& code) const;
    /** Read `#RRGGBB`. */
    std::string readColor(std::string_view key, std::string_view text, std::array<std::uint8_t, 3>& color) const;

    /** Add a colour; its code must be unique. */
    std::string add(PaletteColor color);
    const std::vector<PaletteColor>& getColors() const { return _colors; }

private:
    const TextLines& _lines;
    std::vector<PaletteColor> _colors;
};

} // namespace osgLego
