#include <osgLego/palette/PaletteFile.h>

#include <osgLego/palette/ColorConfiguration.h>
#include <osgLego/palette/ColorTable.h>
#include <osgLego/palette/KnownColors.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <map>
#include <mutex>
#include <system_error>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

constexpr std::uintmax_t LARGEST_FILE = std::uintmax_t(4) << 20;

/** The size and the time of a file, by which a change is noticed. */
struct FileState
{
    std::uintmax_t size = 0;
    fs::file_time_type time;

    bool operator==(const FileState&) const = default;
};

/** The palettes of the files that were read last. */
class PaletteCache
{
public:
    osg::ref_ptr<const Palette> find(const fs::path& path, const FileState& state)
    {
        const std::scoped_lock lock(_mutex);
        const auto found = _entries.find(path);
        return found != _entries.end() && found->second.state == state ? found->second.palette : nullptr;
    }

    void insert(const fs::path& path, const FileState& state, const osg::ref_ptr<const Palette>& palette)
    {
        constexpr std::size_t MOST_ENTRIES = 16; // a palette takes a quarter of a megabyte
        const std::scoped_lock lock(_mutex);
        if (_entries.size() >= MOST_ENTRIES) _entries.clear();
        _entries[path] = {state, palette};
    }

private:
    struct Entry
    {
        FileState state;
        osg::ref_ptr<const Palette> palette;
    };

    std::mutex _mutex;
    std::map<fs::path, Entry> _entries;
};

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

/** Look at a file without opening it. @return one sentence if it can't be a palette. */
std::string inspect(const fs::path& path, FileState& state)
{
    std::error_code problem;
    const fs::file_status status = fs::status(path, problem);
    if (!fs::exists(status)) return unreadable(path, problem);
    if (!fs::is_regular_file(status))
        return path.string() + " is not a file; expected a palette in a .csv or .ldr file";
    state.size = fs::file_size(path, problem);
    if (!problem) state.time = fs::last_write_time(path, problem);
    if (problem) return unreadable(path, problem);
    if (state.size > LARGEST_FILE)
        return path.string() + ": the palette has " + std::to_string(state.size) + " bytes; expected at most " +
               std::to_string(LARGEST_FILE);
    return {};
}

/** Read a file, which may have grown since its size was looked up. @return one sentence if that fails. */
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

osg::ref_ptr<const Palette> readPaletteFile(const fs::path& path, std::string& error)
{
    static PaletteCache cache;
    const std::string extension = lowerCaseExtension(path);
    if (extension != ".csv" && extension != ".ldr")
    {
        error = "unknown palette '" + path.string() + "'; expected none, ldraw, or a .csv or .ldr file";
        return nullptr;
    }
    FileState state;
    if (error = inspect(path, state); !error.empty()) return nullptr;
    std::error_code ignored;
    const fs::path key = fs::absolute(path, ignored);
    if (osg::ref_ptr<const Palette> found = cache.find(key, state)) return found;
    std::string text;
    if (error = readText(path, text); !error.empty()) return nullptr;
    std::string wrong;
    const std::vector<PaletteColor> colors =
        extension == ".csv" ? readColorTable(text, wrong) : readColorConfiguration(text, getKnownColors(), wrong);
    if (!wrong.empty())
    {
        error = path.string() + (wrong.starts_with("line ") ? ", " : ": ") + wrong;
        return nullptr;
    }
    const osg::ref_ptr<const Palette> palette = Palette::create(colors, error);
    cache.insert(key, state, palette);
    return palette;
}

} // namespace osgLego
