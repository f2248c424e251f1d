#pragma once

#include "LDrawDocument.h"

namespace osgLego
{

/** Reads the lines of an LDrawDocument. Functions that return a string return an error message in one sentence; empty
 * on success. */
class LDrawParser
{
public:
    LDrawParser();

    std::string parse(std::string_view text);
    LDrawDocument takeDocument() { return std::move(_document); }

private:
    std::string readLine(std::string_view line);
    std::string readLineOfType(char type, std::string_view rest);
    void readCommand(std::string_view rest);
    void beginFile(std::string_view name);
    void readColorDefinition(std::string_view rest);
    std::string readReference(std::string_view rest);
    std::string readSurface(std::string_view rest, std::size_t numCorners);
    std::uint32_t indexOf(std::string_view name);

    LDrawDocument _document;
    std::unordered_map<std::string, std::uint32_t> _nameIndices; // by the name as it is written
    std::size_t _file = 0;
    bool _isInFile = true;
};

} // namespace osgLego
