#include "LDrawText.h"

#include <common/ReadableFile.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include <boost/nowide/utf/utf.hpp>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

constexpr std::string_view PART_EXTENSION = ".dat";

/** Check a file without opening it. @return an error message; empty if it can be read. */
std::string findObstacle(const std::string& path)
{
    if (std::string obstacle = findObstacleToReading(path); !obstacle.empty()) return obstacle;
    std::error_code problem;
    if (!fs::is_regular_file(path, problem)) return "it is a device or a pipe; expected a regular file";
    const std::uintmax_t size = fs::file_size(path, problem);
    if (problem) return problem.message();
    if (size <= LARGEST_TEXT) return {};
    return "it has " + std::to_string(size) + " bytes; expected at most " + std::to_string(LARGEST_TEXT);
}

} // namespace

std::optional<std::string> readText(const std::string& path, std::string& error)
{
    error = findObstacle(path);
    if (!error.empty()) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    return readText(file, error);
}

std::optional<std::string> readText(std::istream& stream, std::string& error, std::uintmax_t largest)
{
    constexpr std::size_t BLOCK = std::size_t(1) << 16;
    std::vector<char> block(BLOCK);
    std::string text;
    while (stream.good())
    {
        stream.read(block.data(), BLOCK);
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > largest)
        {
            error = "it has more than " + std::to_string(largest) + " bytes; expected fewer";
            return std::nullopt;
        }
    }
    if (stream.eof()) return text;
    error = "its content can't be read";
    return std::nullopt;
}

std::string toUtf8(std::string_view text)
{
    using Utf8 = boost::nowide::utf::utf_traits<char>;
    bool isUtf8 = true;
    const char* const end = text.data() + text.size();
    for (const char* place = text.data(); isUtf8 && place != end;)
        isUtf8 = boost::nowide::utf::is_valid_codepoint(Utf8::decode(place, end));
    if (isUtf8) return std::string(text);
    std::string result;
    for (const char letter : text)
        Utf8::encode(static_cast<unsigned char>(letter), std::back_inserter(result));
    return result;
}

std::string replaceControlCharacters(std::string_view text)
{
    std::string result(text);
    std::replace_if(
        result.begin(), result.end(), [](char letter) { return static_cast<unsigned char>(letter) < ' '; }, ' ');
    return result;
}

std::string toPartFile(std::string_view number)
{
    return std::string(number).append(PART_EXTENSION);
}

std::string_view toPartNumber(std::string_view file)
{
    return file.ends_with(PART_EXTENSION) ? file.substr(0, file.size() - PART_EXTENSION.size()) : std::string_view();
}

} // namespace osgLego
