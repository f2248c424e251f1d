#include <osgLego/palette/ColorTable.h>

#include <osgLego/PartType.h>
#include <osgLego/palette/ColorText.h>
#include <osgLego/palette/TextLines.h>
#include <osgLego/text/SettingsText.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace osgLego
{

namespace
{

enum Column
{
    CODE,
    NAME,
    RGB,
    EDGE,
    BRICK_LINK,
    BRICKS,
    PLATES,
    NUM_COLUMNS
};
constexpr std::array<std::string_view, NUM_COLUMNS> COLUMNS{"code",      "name",   "rgb",   "edge",
                                                            "bricklink", "bricks", "plates"};
constexpr std::string_view HEADER = "code,name,rgb,edge,bricklink,bricks,plates";

using Fields = std::array<std::string_view, NUM_COLUMNS>;

/** Divide a line at its commas. @return false if it has another number of fields. */
bool divide(std::string_view line, Fields& fields)
{
    for (std::size_t column = 0; column < NUM_COLUMNS; ++column)
    {
        const auto end = line.find(',');
        const bool isLast = column + 1 == NUM_COLUMNS;
        if ((end == std::string_view::npos) != isLast) return false;
        fields[column] = trimmed(line.substr(0, end));
        if (!isLast) line.remove_prefix(end + 1);
    }
    return true;
}

std::string readBrickLink(const TextLines& lines, std::string_view text, std::int32_t& number)
{
    if (text.empty()) return {};
    std::int32_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || value < 1)
        return lines.expected("a number of BrickLink from 1 to 2147483647, or nothing", text);
    number = value;
    return {};
}

/** Read a character for each size of parts: 1 if parts of this size were made, otherwise 0. */
std::string readSizes(const TextLines& lines, std::string_view key, std::string_view text, std::uint16_t& sizes)
{
    const auto isDigit = [](char character) { return character == '0' || character == '1'; };
    if (text.size() != PART_SIZES.size() || !std::all_of(text.begin(), text.end(), isDigit))
        return lines.expected(std::to_string(PART_SIZES.size()) + " digits 0 or 1 as " + std::string(key), text);
    sizes = 0;
    for (std::size_t size = 0; size < text.size(); ++size)
        if (text[size] == '1') sizes = static_cast<std::uint16_t>(sizes | 1u << size);
    return {};
}

std::string readRow(const TextLines& lines, ColorText& text)
{
    Fields fields;
    if (!divide(lines.get(), fields)) return lines.expected("the fields " + std::string(HEADER), lines.get());
    PaletteColor color;
    std::array<std::uint8_t, 3> edge{};
    std::string error = text.readCode(fields[CODE], color.code);
    if (error.empty()) error = text.readName(fields[NAME], color.name);
    if (error.empty()) error = text.readColor(COLUMNS[RGB], fields[RGB], color.color);
    if (error.empty()) error = text.readColor(COLUMNS[EDGE], fields[EDGE], edge);
    if (error.empty()) error = readBrickLink(lines, fields[BRICK_LINK], color.brickLink);
    if (error.empty()) error = readSizes(lines, COLUMNS[BRICKS], fields[BRICKS], color.bricks);
    if (error.empty()) error = readSizes(lines, COLUMNS[PLATES], fields[PLATES], color.plates);
    return error.empty() ? text.add(color) : error;
}

} // namespace

std::vector<PaletteColor> readColorTable(std::string_view text, std::string& error)
{
    TextLines lines(text);
    ColorText colors(lines);
    bool isHeaderRead = false;
    while (lines.next())
    {
        std::string wrong = colors.checkLength();
        const bool isIgnored = lines.get().empty() || lines.get().starts_with('#');
        if (wrong.empty() && !isIgnored)
        {
            Fields fields;
            if (isHeaderRead)
                wrong = readRow(lines, colors);
            else if (!divide(lines.get(), fields) || fields != COLUMNS)
                wrong = lines.expected(std::string(HEADER), lines.get());
            isHeaderRead = true;
        }
        if (wrong.empty()) continue;
        error = wrong;
        return {};
    }
    if (colors.getColors().empty()) error = "expected " + std::string(HEADER) + " and at least one line with a colour";
    return colors.getColors();
}

} // namespace osgLego
