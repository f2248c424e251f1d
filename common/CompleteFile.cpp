#include <common/CompleteFile.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

fs::path temporaryPathOf(const fs::path& path)
{
    fs::path name = path.stem();
    name += "." + std::to_string(getpid()) + ".part";
    name += path.extension();
    return path.parent_path() / name;
}

/** A writer's message, with the file's own name in place of the temporary one. */
std::string renamed(std::string text, const std::string& from, const std::string& to)
{
    for (auto place = text.find(from); place != std::string::npos; place = text.find(from, place + to.size()))
        text.replace(place, from.size(), to);
    return text;
}

/** Whether a name is that of a device or a pipe, which is written directly. */
bool isSpecial(const fs::path& path)
{
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) && !fs::is_directory(path, ignored);
}

} // namespace

std::string findObstacleToWriting(const std::string& fileName)
{
    std::error_code ignored;
    const fs::path path(fileName);
    if (fs::is_directory(path, ignored)) return "it is a folder; expected a file";
    if (isSpecial(path)) return {};
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const std::string name = "'" + folder.string() + "'";
    if (!fs::exists(folder, ignored)) return "there is no folder " + name + "; expected an existing one";
    if (!fs::is_directory(folder, ignored)) return name + " is a file; expected a folder";
    if (access(folder.c_str(), W_OK) == 0) return {};
    const std::string reason = std::error_code(errno, std::generic_category()).message();
    return "the folder " + name + " can't be written to: " + reason + "; expected a writable folder";
}

bool isSameFile(const std::string& fileName, const std::string& otherName)
{
    if (isSpecial(fileName)) return false;
    return fs::weakly_canonical(fs::absolute(fileName)) == fs::weakly_canonical(fs::absolute(otherName));
}

std::string writeCompleteFile(const std::string& fileName, const std::function<std::string(const std::string&)>& write)
{
    if (std::string obstacle = findObstacleToWriting(fileName); !obstacle.empty()) return obstacle;
    std::error_code ignored;
    // Replace the target of a link, not the link.
    const fs::path path =
        fs::is_symlink(fileName, ignored) ? fs::weakly_canonical(fileName, ignored) : fs::path(fileName);
    if (isSpecial(path)) return write(fileName);
    const fs::path temporary = temporaryPathOf(path);
    std::string why = renamed(write(temporary.string()), temporary.string(), fileName);
    if (why.empty())
    {
        std::error_code error;
        fs::rename(temporary, path, error);
        if (error) why = error.message();
    }
    if (!why.empty()) fs::remove(temporary, ignored);
    return why;
}

} // namespace osgLego
