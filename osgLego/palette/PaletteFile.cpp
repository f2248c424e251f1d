#include <osgLego/palette/PaletteFile.h>

#include <osgLego/palette/ColorConfiguration.h>
#include <osgLego/palette/ColorTable.h>
#include <osgLego/palette/KnownColors.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

constexpr std::uintmax_t LARGEST_FILE = std::uintmax_t(4) << 20;

std::string lowerCaseExtension(const fs::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char character) { return static_cast<char>(std::tolower(character)); });
    return extension;
}

std::string unreadable(const fs::path& path, const std::error_code& problem)
{
    return path.string() + ": the palette can't be read: " + problem.message();
}

/** Check a file without opening it. @return an error message; empty if it may be a palette. */
std::string inspect(const fs::path& path)
{
    std::error_code problem;
    const fs::file_status status = fs::status(path, problem);
    if (!fs::exists(status)) return unreadable(path, problem);
    if (!fs::is_regular_file(status))
        return path.string() + " is not a file; expected a palette in a .csv or .ldr file";
    const std::uintmax_t size = fs::file_size(path, problem);
    if (problem) return unreadable(path, problem);
    if (size > LARGEST_FILE)
        return path.string() + ": the palette has " + std::to_string(size) + " bytes; expected at most " +
               std::to_string(LARGEST_FILE);
    return {};
}

/** Read a file, which may have grown since its size was checked. @return an error message; empty on success. */
std::string readText(const fs::path& path, std::string& text)
{
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    text.resize(LARGEST_FILE);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    return file.eof() || file.good() ? std::string()
                                     : unreadable(path, std::error_code(errno, std::generic_category()));
}

} // namespace

std::vector<PaletteColor> readPaletteFile(const fs::path& path, std::string& error)
{
    const std::string extension = lowerCaseExtension(path);
    if (extension != ".csv" && extension != ".ldr")
    {
        error = "unknown palette '" + path.string() + "'; expected none, ldraw, or a .csv or .ldr file";
        return {};
    }
    std::string text;
    error = inspect(path);
    if (error.empty()) error = readText(path, text);
    if (!error.empty()) return {};
    std::string wrong;
    std::vector<PaletteColor> colors =
        extension == ".csv" ? readColorTable(text, wrong) : readColorConfiguration(text, getKnownColors(), wrong);
    if (!wrong.empty()) error = path.string() + (wrong.starts_with("line ") ? ", " : ": ") + wrong;
    return colors;
}

} // namespace osgLego
