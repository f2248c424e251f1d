#include <common/CompleteFile.h>

#include <common/DescriptorBuffer.h>
#include <common/TemporaryFile.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

/** The file that a name refers to through symbolic links, whether or not it exists: std::filesystem::weakly_canonical()
 * does not follow links to files that don't exist. Links that refer to each other stay as they are. */
fs::path followLinks(fs::path path)
{
    constexpr int MOST_LINKS = 40; // as in Linux
    std::error_code error;
    for (int link = 0; link < MOST_LINKS && fs::is_symlink(path, error); ++link)
        path = path.parent_path() / fs::read_symlink(path, error);
    return path;
}

/** Whether a name is that of a device or a pipe, which is written directly; also by links of the system, such as
 * /dev/stdout, whose targets have no names. */
bool isSpecial(const fs::path& path)
{
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) && !fs::is_directory(path, ignored);
}

/** Write to a descriptor through a stream. @return the reason if this fails, or an empty text. */
std::string writeTo(int descriptor, const std::function<std::string(std::ostream&)>& write)
{
    DescriptorBuffer buffer(descriptor);
    std::ostream stream(&buffer);
    const std::string why = write(stream);
    stream.flush();
    if (buffer.getError() != 0) return std::strerror(buffer.getError());
    return why.empty() && !stream ? "its content can't be written" : why;
}

std::string writeDevice(const std::string& name, const std::function<std::string(std::ostream&)>& write)
{
    const int descriptor = open(name.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return std::strerror(errno);
    std::string why;
    try
    {
        why = writeTo(descriptor, write);
    }
    catch (...)
    {
        close(descriptor);
        throw;
    }
    if (close(descriptor) != 0 && why.empty()) why = std::strerror(errno);
    return why;
}

} // namespace

std::string findObstacleToWriting(const std::string& fileName)
{
    if (isSpecial(fileName)) return {};
    std::error_code ignored;
    const fs::path path = followLinks(fileName);
    if (fs::is_symlink(path, ignored)) return "its symbolic links refer to each other; expected a file";
    if (fs::is_directory(path, ignored)) return "it is a folder; expected a file";
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const std::string name = "'" + folder.string() + "'";
    if (!fs::exists(folder, ignored)) return "there is no folder " + name + "; expected an existing one";
    if (!fs::is_directory(folder, ignored)) return name + " is a file; expected a folder";
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        return "the folder " + name + " can't be written to: " + std::strerror(errno) + "; expected a writable folder";
    std::error_code error;
    const bool isThere = fs::exists(path, error);
    if (error == std::errc::filename_too_long) return error.message() + "; expected another name";
    if (error) return error.message();
    if (isThere && access(path.c_str(), W_OK) != 0)
        return std::string("it can't be replaced: ") + std::strerror(errno) + "; expected a writable file";
    return {};
}

bool isSameFile(const std::string& fileName, const std::string& otherName)
{
    if (isSpecial(fileName)) return false;
    return fs::weakly_canonical(fs::absolute(followLinks(fileName))) ==
           fs::weakly_canonical(fs::absolute(followLinks(otherName)));
}

std::string writeCompleteFile(const std::string& fileName, const std::function<std::string(std::ostream&)>& write)
{
    if (std::string obstacle = findObstacleToWriting(fileName); !obstacle.empty()) return obstacle;
    if (isSpecial(fileName)) return writeDevice(fileName, write);
    TemporaryFile file(followLinks(fileName).string()); // replace the target of a link, not the link
    if (file.getDescriptor() < 0) return std::strerror(errno);
    std::string why = writeTo(file.getDescriptor(), write);
    return why.empty() ? file.publish() : why;
}

} // namespace osgLego
