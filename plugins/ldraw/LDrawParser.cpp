#include "LDrawParser.h"

#include "LDrawText.h"

#include <osgLego/text/SettingsText.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

namespace osgLego
{

namespace
{

constexpr std::string_view SPACE = " \t\r";
constexpr std::string_view BYTE_ORDER_MARK = "\xef\xbb\xbf";

/** Cut the first word off a text; empty if there is none. */
std::string_view takeWord(std::string_view& text)
{
    const auto begin = std::min(text.find_first_not_of(SPACE), text.size());
    const auto end = std::min(text.find_first_of(SPACE, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

template <typename Number, typename... Format>
bool readWhole(std::string_view word, Number& number, Format... format)
{
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, number, format...);
    return error == std::errc() && stop == end && !word.empty();
}

std::string badNumber(std::string_view word)
{
    if (word.empty()) return "it ends too early; expected more numbers";
    return quoteForMessage(word) + " is not a coordinate; expected a number from -1e+07 to 1e+07";
}

std::string readNumbers(std::string_view& text, std::span<double> numbers)
{
    for (double& number : numbers)
    {
        const std::string_view word = takeWord(text);
        const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
        if (!readWhole(digits, number) || !(std::abs(number) <= LDrawDocument::LARGEST_NUMBER)) return badNumber(word);
    }
    return {};
}

/** Read a colour: a code, or a direct colour such as 0x2FF8000. */
std::string readColor(std::string_view& text, std::int32_t& color)
{
    constexpr int HEXADECIMAL = 16;
    const std::string_view word = takeWord(text);
    const std::size_t prefix = word.starts_with("0x") || word.starts_with("0X") ? 2 : word.starts_with('#') ? 1 : 0;
    const bool isRead = prefix > 0 ? readWhole(word.substr(prefix), color, HEXADECIMAL) : readWhole(word, color);
    if (isRead && color >= 0) return {};
    return quoteForMessage(word) + " is not a colour; expected a code, or 0x2 and six hexadecimal digits";
}

/** A text of the header. */
std::string toText(std::string_view text)
{
    return toUtf8(trimmed(replaceControlCharacters(text)));
}

/** The title in the first line of a model; empty if that is a command, or the placeholder of an editor. */
std::string findTitle(std::string_view line)
{
    constexpr std::array COMMANDS{"Author:", "BFC",   "CLEAR",   "FILE", "Name:", "NOFILE",
                                  "PAUSE",   "PRINT", "ROTSTEP", "SAVE", "STEP",  "WRITE"};
    std::string_view rest = line;
    const std::string_view word = takeWord(rest);
    if (word == LDrawDocument::TITLE_PREFIX) return toText(rest);
    const bool isCommand = word.starts_with('!') || word.starts_with("//") ||
                           std::find(COMMANDS.begin(), COMMANDS.end(), word) != COMMANDS.end();
    const std::string name = LDrawDocument::normalizeName(line);
    return isCommand || name == "untitled" || name == "untitled model" ? std::string() : toText(line);
}

/** The author in the header of a model; empty if it is only the program that wrote it. */
std::string findAuthor(std::string_view text)
{
    std::string author = toText(text);
    return author == LDrawDocument::DEFAULT_AUTHOR || author == "MLCad" ? std::string() : author;
}

} // namespace

LDrawParser::LDrawParser()
{
    _document._files.emplace_back();
}

std::optional<LDrawDocument> LDrawParser::parse(std::string_view text, std::string& error)
{
    LDrawParser parser;
    error = parser.readText(text);
    if (!error.empty()) return std::nullopt;
    return std::move(parser._document);
}

std::string LDrawParser::readText(std::string_view text)
{
    if (text.starts_with(BYTE_ORDER_MARK)) text.remove_prefix(BYTE_ORDER_MARK.size());
    for (std::size_t number = 1; !text.empty(); ++number)
    {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string why = readLine(text.substr(0, end));
        if (!why.empty()) return "line " + std::to_string(number) + ": " + why;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return {};
}

std::string LDrawParser::readLine(std::string_view line)
{
    if (line.size() > LDrawDocument::LONGEST_LINE)
        return "it has " + std::to_string(line.size()) + " characters; expected at most " +
               std::to_string(LDrawDocument::LONGEST_LINE);
    const std::string_view type = takeWord(line);
    if (type.empty()) return {};
    if (type.size() == 1 && type.front() >= '0' && type.front() <= '5') return readLineOfType(type.front(), line);
    return "it begins with " + quoteForMessage(type) + "; expected a type of line, 0 to 5, as in files of LDraw";
}

std::string LDrawParser::readLineOfType(char type, std::string_view rest)
{
    const bool isTitle = std::exchange(_isTitleNext, false);
    if (type == '0' && _isInFile) readHeader(trimmed(rest), isTitle);
    if (type == '0') readCommand(rest);
    if (!_isInFile) return {};
    switch (type)
    {
    case '1':
        return readReference(rest);
    case '3':
        return readSurface(rest, 3);
    case '4':
        return readSurface(rest, 4);
    default:
        return {};
    }
}

void LDrawParser::readCommand(std::string_view rest)
{
    const std::string_view command = takeWord(rest);
    if (command == "FILE") beginFile(trimmed(rest));
    if (command == "NOFILE") _isInFile = false;
    if (command == "!COLOUR") readColorDefinition(rest);
}

/** Read a line that may be one of those at the beginning of a model.
 * @param isTitle whether it is the first one of the main model. */
void LDrawParser::readHeader(std::string_view line, bool isTitle)
{
    const LDrawFile& file = _document._files[_file];
    if (!file.references.empty() || !file.triangles.empty()) return;
    ModelHeader& header = _document._header;
    std::string_view rest = line;
    const std::string_view word = takeWord(rest);
    // The licence of one file is not that of all if another one has another.
    if (_file > 0 && word == "!LICENSE" && toText(rest) != header.license) header.license.clear();
    if (_file > 0) return;
    if (isTitle) header.title = findTitle(line);
    if (word == "Author:" && header.author.empty()) header.author = findAuthor(rest);
    if (word == "!LICENSE" && header.license.empty()) header.license = toText(rest);
}

void LDrawParser::beginFile(std::string_view name)
{
    std::vector<LDrawFile>& files = _document._files;
    const bool isFirst =
        files.size() == 1 && files[0].name.empty() && files[0].references.empty() && files[0].triangles.empty();
    if (!isFirst) files.emplace_back();
    _file = files.size() - 1;
    _isTitleNext = isFirst;
    files[_file].name = LDrawDocument::normalizeName(name);
    // Of files with one name, the first is used.
    _document._filesByName.emplace(files[_file].name, _file);
    _isInFile = true;
}

/** Definitions that can't be read are ignored, as comments are, and leave their colours without a definition. */
void LDrawParser::readColorDefinition(std::string_view rest)
{
    LDrawColorDefinition definition;
    std::int32_t value = -1;
    bool hasCode = false;
    takeWord(rest); // the name
    for (std::string_view key = takeWord(rest); !key.empty(); key = takeWord(rest))
    {
        if (key == "CODE") hasCode = readColor(rest, definition.code).empty();
        if (key == "VALUE" && !readColor(rest, value).empty()) return;
    }
    if (!hasCode || value < 0) return;
    for (std::size_t channel = 0; channel < 3; ++channel)
        definition.color[channel] = static_cast<std::uint8_t>(value >> (8 * (2 - channel)));
    _document._colors.push_back(definition);
}

std::string LDrawParser::readReference(std::string_view rest)
{
    LDrawReference reference;
    if (std::string why = readColor(rest, reference.color); !why.empty()) return why;
    std::array<double, 12> numbers{};
    if (std::string why = readNumbers(rest, numbers); !why.empty()) return why;
    const std::string_view name = trimmed(rest);
    if (name.empty()) return "it ends too early; expected the name of a part or a submodel";
    reference.transform.place = {numbers[0], numbers[1], numbers[2]};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            reference.transform.axes[column][row] = numbers[static_cast<std::size_t>(3 + 3 * row + column)];
    reference.name = indexOf(name);
    _document._files[_file].references.push_back(reference);
    return {};
}

std::string LDrawParser::readSurface(std::string_view rest, std::size_t numCorners)
{
    LDrawTriangle triangle;
    if (std::string why = readColor(rest, triangle.color); !why.empty()) return why;
    std::array<double, 12> numbers{};
    if (std::string why = readNumbers(rest, std::span(numbers).first(3 * numCorners)); !why.empty()) return why;
    const auto cornerOf = [&](std::size_t index)
    { return glm::dvec3(numbers[3 * index], numbers[3 * index + 1], numbers[3 * index + 2]); };
    for (std::size_t last = 2; last < numCorners; ++last)
    {
        triangle.corners = {cornerOf(0), cornerOf(last - 1), cornerOf(last)};
        _document._files[_file].triangles.push_back(triangle);
    }
    return {};
}

std::uint32_t LDrawParser::indexOf(std::string_view name)
{
    const auto [place, isNew] =
        _nameIndices.emplace(std::string(name), static_cast<std::uint32_t>(_document._names.size()));
    if (isNew) _document._names.push_back(LDrawDocument::normalizeName(name));
    return place->second;
}

} // namespace osgLego
