#pragma once

#include "LDrawDocument.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace osgLego
{

/** Reads the lines of an LDrawDocument. Private functions that return a string return an error message in one sentence;
 * empty on success. */
class LDrawParser
{
public:
    /** Read the text of a file.
     * @return nothing, with one sentence in `error` that names the bad line, if it is not LDraw. */
    static std::optional<LDrawDocument> parse(std::string_view text, std::string& error);

private:
    LDrawParser();

    std::string readText(std::string_view text);
    std::string readLine(std::string_view line);
    std::string readLineOfType(char type, std::string_view rest);
    void readCommand(std::string_view rest);
    void readHeader(std::string_view line, bool isTitle);
    void beginFile(std::string_view name);
    void readColorDefinition(std::string_view rest);
    std::string readReference(std::string_view rest);
    std::string readSurface(std::string_view rest, std::size_t numCorners);
    std::uint32_t indexOf(std::string_view name);

    LDrawDocument _document;
    std::unordered_map<std::string, std::uint32_t> _nameIndices; // by the name as it is written
    std::size_t _file = 0;
    bool _isInFile = true;
    bool _isTitleNext = true; // the first line of the main model
};

} // namespace osgLego
