#include <osgLego/palette/ColorConfiguration.h>

#include <osgLego/palette/ColorText.h>
#include <osgLego/palette/TextLines.h>
#include <osgLego/text/SettingsText.h>

#include <algorithm>
#include <array>

namespace osgLego
{

namespace
{

using Words = std::vector<std::string_view>;

constexpr std::array<std::string_view, 8> FINISHES{"ALPHA",  "LUMINANCE",      "CHROME", "PEARLESCENT",
                                                   "RUBBER", "MATTE_METALLIC", "METAL",  "MATERIAL"};
constexpr std::string_view EXAMPLE = "0 !COLOUR Black CODE 0 VALUE #1B2A34 EDGE #808080";

Words divide(std::string_view line)
{
    constexpr std::string_view SPACE = " \t";
    Words words;
    while (!line.empty())
    {
        const auto end = std::min(line.find_first_of(SPACE), line.size());
        words.push_back(line.substr(0, end));
        line = trimmed(line.substr(end));
    }
    return words;
}

bool isColor(const Words& words)
{
    return words.size() >= 2 && words[0] == "0" && words[1] == "!COLOUR";
}

bool isSolid(const Words& words)
{
    return std::find_first_of(words.begin(), words.end(), FINISHES.begin(), FINISHES.end()) == words.end();
}

/** The word behind a key; empty if there is none. */
std::string_view valueOf(const Words& words, std::string_view key)
{
    const auto place = std::find(words.begin(), words.end(), key);
    return words.end() - place >= 2 ? place[1] : std::string_view();
}

bool isPlaceholder(std::string_view code)
{
    return code == std::to_string(ColorText::MAIN_COLOR) || code == std::to_string(ColorText::EDGE_COLOR);
}

void copyFacts(std::span<const PaletteColor> known, PaletteColor& color)
{
    const auto isSame = [&](const PaletteColor& other) { return other.code == color.code; };
    const auto found = std::find_if(known.begin(), known.end(), isSame);
    if (found == known.end()) return;
    if (color.code == PaletteColor::BLACK) color.color = found->color;
    color.brickLink = found->brickLink;
    color.bricks = found->bricks;
    color.plates = found->plates;
}

std::string readColor(const Words& words, std::span<const PaletteColor> known, ColorText& text)
{
    PaletteColor color;
    std::string error = text.readName(words.size() > 2 ? words[2] : std::string_view(), color.name);
    if (error.empty()) error = text.readCode(valueOf(words, "CODE"), color.code);
    if (error.empty()) error = text.readColor("VALUE", valueOf(words, "VALUE"), color.color);
    if (!error.empty()) return error;
    copyFacts(known, color);
    return text.add(color);
}

} // namespace

std::vector<PaletteColor> readColorConfiguration(std::string_view text, std::span<const PaletteColor> known,
                                                 std::string& error)
{
    TextLines lines(text);
    ColorText colors(lines);
    while (lines.next())
    {
        std::string wrong = colors.checkLength();
        if (wrong.empty())
        {
            const Words words = divide(lines.get());
            if (isColor(words) && isSolid(words) && !isPlaceholder(valueOf(words, "CODE")))
                wrong = readColor(words, known, colors);
        }
        if (wrong.empty()) continue;
        error = wrong;
        return {};
    }
    if (colors.getColors().empty())
        error = "expected at least one line with a solid colour, such as '" + std::string(EXAMPLE) + "'";
    return colors.getColors();
}

} // namespace osgLego
