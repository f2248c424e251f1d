#include <osgLego/palette/ColorText.h>

#include <osgLego/palette/TextLines.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace osgLego
{

namespace
{

bool isNameCharacter(unsigned char character)
{
    constexpr unsigned char DELETE = 0x7f;
    return character >= ' ' && character != DELETE && character != '"' && character != ',';
}

} // namespace

std::string ColorText::checkLength() const
{
    if (_lines.get().size() <= LONGEST_LINE) return {};
    return _lines.expected("at most " + std::to_string(LONGEST_LINE) + " bytes", _lines.get());
}

std::string ColorText::readName(std::string_view text, std::string& name) const
{
    if (text.empty() || text.size() > LONGEST_NAME || !std::all_of(text.begin(), text.end(), isNameCharacter))
        return _lines.expected("a name of 1 to " + std::to_string(LONGEST_NAME) +
                                   " bytes without quotation marks, commas and control characters",
                               text);
    name = text;
    return {};
}

std::string ColorText::readCode(std::string_view text, std::int32_t& code) const
{
    std::int32_t value = -1;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || value < 0 || value == MAIN_COLOR ||
        value == EDGE_COLOR)
        return _lines.expected("a code of LDraw from 0 to 2147483647 except 16 and 24", text);
    code = value;
    return {};
}

std::string ColorText::readColor(std::string_view key, std::string_view text, std::array<std::uint8_t, 3>& color) const
{
    constexpr std::size_t LENGTH = 7;
    std::uint32_t value = 0;
    const auto [end, problem] =
        std::from_chars(text.data() + std::min<std::size_t>(text.size(), 1), text.data() + text.size(), value, 16);
    if (text.size() != LENGTH || text[0] != '#' || problem != std::errc() || end != text.data() + text.size())
        return _lines.expected("#RRGGBB as " + std::string(key), text);
    const auto byteAt = [&](unsigned int shift) { return static_cast<std::uint8_t>(value >> shift & 0xff); };
    color = {byteAt(16), byteAt(8), byteAt(0)};
    return {};
}

std::string ColorText::add(PaletteColor color)
{
    const auto isSame = [&](const PaletteColor& other) { return other.code == color.code; };
    if (std::any_of(_colors.begin(), _colors.end(), isSame))
        return _lines.expected("a code that is not in a line above", std::to_string(color.code));
    if (_colors.size() == PaletteLimits::MAXIMUM_COLORS)
        return _lines.expected("at most " + std::to_string(PaletteLimits::MAXIMUM_COLORS) + " colours", color.name);
    _colors.push_back(std::move(color));
    return {};
}

} // namespace osgLego
