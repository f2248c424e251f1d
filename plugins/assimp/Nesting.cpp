#include "Nesting.h"

#include <common/JsonValue.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

using osgLego::JsonValue;

namespace
{

/** The beginning of a comment, which ends with its line; in JSON, no character. */
enum class Comment : char
{
    NONE = '\0',
    SEMICOLON = ';'
};

/** Call a function with the place of each bracket outside of strings and comments, and its level from 1 on, until it
 * returns false. */
template <typename Visit>
void forEachBracket(std::string_view text, Comment comment, const Visit& visit)
{
    std::size_t level = 0;
    bool isQuoted = false;
    for (std::size_t place = 0; place < text.size(); ++place)
    {
        const char character = text[place];
        if (character == '"')
            isQuoted = !isQuoted;
        else if (isQuoted && character == '\\' && comment == Comment::NONE)
            ++place;
        else if (!isQuoted && comment != Comment::NONE && character == static_cast<char>(comment))
            place = std::min(text.find('\n', place), text.size());
        else if (!isQuoted && (character == '{' || character == '['))
        {
            if (!visit(place, ++level)) return;
        }
        else if (!isQuoted && (character == '}' || character == ']') && level > 0)
        {
            if (!visit(place, level--)) return;
        }
    }
}

bool isDeepText(std::string_view text, Comment comment)
{
    bool isDeep = false;
    forEachBracket(text, comment,
                   [&isDeep](std::size_t, std::size_t level) { return !(isDeep = level > MOST_LEVELS); });
    return isDeep;
}

/** The place behind the tag of an element, whose attributes may contain brackets. */
std::size_t findEndOfTag(std::string_view text, std::size_t place)
{
    char quote = '\0';
    for (; place < text.size(); ++place)
    {
        const char character = text[place];
        if (quote != '\0')
            quote = character == quote ? '\0' : quote;
        else if (character == '"' || character == '\'')
            quote = character;
        else if (character == '>')
            return place;
    }
    return std::string_view::npos;
}

bool isDeepXml(std::string_view text)
{
    std::size_t level = 0;
    for (std::size_t place = text.find('<'); place != std::string_view::npos; place = text.find('<', place))
    {
        const std::string_view rest = text.substr(place);
        if (rest.starts_with("<!--"))
            place = text.find("-->", place);
        else if (rest.starts_with("<![CDATA["))
            place = text.find("]]>", place);
        else
        {
            place = findEndOfTag(text, place);
            if (rest.starts_with("</"))
                level -= level > 0 ? 1 : 0;
            else if (place != std::string_view::npos && text[place - 1] != '/' && rest[1] != '?' && rest[1] != '!')
                ++level;
        }
        if (level > MOST_LEVELS) return true;
    }
    return false;
}

/** Reads numbers of a binary file, least significant byte first. */
std::uint64_t readNumber(std::string_view bytes, std::size_t place, std::size_t size)
{
    std::uint64_t number = 0;
    for (std::size_t byte = size; byte-- > 0;)
        number = number << 8 | static_cast<unsigned char>(bytes[place + byte]);
    return number;
}

/** The elements of a binary file that contain a place. */
class OpenElements
{
public:
    explicit OpenElements(std::size_t size) : _ends{size} {}

    /** Leave the elements that end before a place. */
    void leave(std::size_t place)
    {
        while (_ends.size() > 1 && _ends.back() <= place)
            _ends.pop_back();
    }
    /** The end of the innermost element; that of the file outside of all. */
    std::size_t getEnd() const { return _ends.back(); }
    void enter(std::size_t end) { _ends.push_back(end); }
    bool areTooMany() const { return _ends.size() > MOST_LEVELS + 1; }

private:
    std::vector<std::size_t> _ends;
};

bool isDeepBinaryFbx(std::string_view bytes)
{
    constexpr std::size_t VERSION = 23;
    constexpr std::size_t FIRST = 27;
    constexpr std::uint64_t WIDE = 7500; // the first version with offsets of 64 bits
    if (bytes.size() < FIRST) return false;
    const std::size_t word = readNumber(bytes, VERSION, 4) >= WIDE ? 8 : 4;
    const std::size_t header = 3 * word + 1;
    OpenElements open(bytes.size());
    for (std::size_t place = FIRST; place < bytes.size() && bytes.size() - place >= header; open.leave(place))
    {
        const std::uint64_t end = readNumber(bytes, place, word);
        const std::uint64_t length = readNumber(bytes, place + 2 * word, word); // of properties
        const std::size_t begin = place + header + static_cast<unsigned char>(bytes[place + 3 * word]);
        if (end == 0) // after the last record of a list
            place += header;
        else if (end > open.getEnd() || begin > end || length > end - begin)
            return false; // damaged, as Assimp notices
        else
        {
            open.enter(end);
            place = begin + length;
        }
        if (open.areTooMany()) return true;
    }
    return false;
}

bool isDeepFbx(std::string_view content)
{
    return content.starts_with("Kaydara FBX Binary") ? isDeepBinaryFbx(content)
                                                     : isDeepText(content, Comment::SEMICOLON);
}

bool isDeepB3d(std::string_view bytes)
{
    constexpr std::size_t HEADER = 8;     // of a chunk: its type and length
    constexpr std::size_t TRANSFORM = 40; // after the name of a node
    OpenElements open(bytes.size());
    std::size_t place = HEADER + 4; // after the version
    while (place < bytes.size() && bytes.size() - place >= HEADER)
    {
        const std::uint64_t length = readNumber(bytes, place + 4, 4);
        const bool isNode = bytes.substr(place, 4) == "NODE";
        place += HEADER;
        if (length > open.getEnd() - std::min(place, open.getEnd())) return false; // damaged, as Assimp notices
        const std::size_t end = place + length;
        if (isNode) open.enter(end);
        place = isNode ? std::min(bytes.find('\0', place), end) + 1 + TRANSFORM : end;
        if (open.areTooMany()) return true;
        open.leave(place);
    }
    return false;
}

/** Whether a text ends with a key of JSON, which may be escaped, and a colon. */
bool endsWithKey(std::string_view text, std::string_view key)
{
    constexpr const char* SPACE = " \t\r\n";
    const std::size_t colon = text.find_last_not_of(SPACE);
    if (colon == std::string_view::npos || text[colon] != ':') return false;
    text = text.substr(0, text.find_last_not_of(SPACE, colon - 1) + 1);
    if (text.size() < 2 || text.back() != '"') return false;
    const auto isEscaped = [text](std::size_t quote)
    {
        const std::size_t before = text.substr(0, quote).find_last_not_of('\\');
        return (quote - (before == std::string_view::npos ? 0 : before + 1)) % 2 == 1;
    };
    std::size_t begin = text.find_last_of('"', text.size() - 2);
    while (begin != std::string_view::npos && begin > 0 && isEscaped(begin))
        begin = text.find_last_of('"', begin - 1);
    if (begin == std::string_view::npos) return false;
    const std::optional<JsonValue> name = JsonValue::parse(std::string(text.substr(begin)));
    return name && name->toText() == key;
}

/** The arrays of nodes in the JSON text of glTF, themselves as text. */
std::vector<std::string_view> findNodes(std::string_view json)
{
    std::size_t begin = std::string_view::npos;
    std::vector<std::string_view> arrays;
    const auto visit = [&](std::size_t place, std::size_t level)
    {
        if (level != 2) return true;
        if (json[place] == '[' && endsWithKey(json.substr(0, place), "nodes"))
            begin = place;
        else if (json[place] == ']' && begin != std::string_view::npos)
        {
            arrays.push_back(json.substr(begin, place + 1 - begin));
            begin = std::string_view::npos;
        }
        return true;
    };
    forEachBracket(json, Comment::NONE, visit);
    return arrays;
}

/** The number of the node above each node. @return nothing if a node has two, or does not exist. */
std::optional<std::vector<std::size_t>> findParents(const std::vector<JsonValue>& nodes)
{
    std::vector<std::size_t> parents(nodes.size(), nodes.size());
    for (std::size_t parent = 0; parent < nodes.size(); ++parent)
    {
        if (!nodes[parent].contains("children")) continue;
        for (const JsonValue& child : nodes[parent]["children"].getElements())
        {
            std::size_t& known = parents.at(static_cast<std::size_t>(child.toInteger()));
            if (known != nodes.size()) return std::nullopt;
            known = parent;
        }
    }
    return parents;
}

bool isDeepTree(const std::vector<std::size_t>& parents)
{
    for (std::size_t node = 0; node < parents.size(); ++node)
    {
        std::size_t level = 1;
        for (std::size_t above = parents[node]; above < parents.size(); above = parents[above])
            if (++level > MOST_LEVELS) return true;
    }
    return false;
}

std::string describe(const std::string& elements)
{
    return "its " + elements + " are nested too deeply; expected at most " + std::to_string(MOST_LEVELS) + " levels";
}

std::string findObstacleOfNodes(std::string_view json)
try
{
    const std::vector<std::string_view> arrays = findNodes(json);
    if (arrays.size() > 1) return "it has several lists of nodes; expected one";
    const std::optional<JsonValue> nodes =
        arrays.empty() ? std::nullopt : JsonValue::parse(std::string(arrays.front()));
    if (!nodes) return {}; // no JSON, as Assimp notices
    const std::optional<std::vector<std::size_t>> parents = findParents(nodes->getElements());
    if (!parents) return "a node is listed twice among the children of nodes; expected one parent for each node";
    return isDeepTree(*parents) ? describe("nodes") : std::string();
}
catch (const std::logic_error&)
{
    return {}; // children that are no numbers of nodes, as Assimp notices
}

} // namespace

std::string findNestingObstacle(const std::string& format, std::string_view content)
{
    if (format == "glb" || format == "gltf")
        return isDeepText(content, Comment::NONE) ? describe("values") : findObstacleOfNodes(content);
    const bool isDeep = format == "fbx"   ? isDeepFbx(content)
                        : format == "b3d" ? isDeepB3d(content)
                                          : isDeepXml(content);
    return isDeep ? describe("elements") : std::string();
}
