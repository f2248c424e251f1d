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

/** Whether a name is that of a device or a pipe, which is written directly. */
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
    std::string why = writeTo(descriptor, write);
    if (close(descriptor) != 0 && why.empty()) why = std::strerror(errno);
    return why;
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
    if (access(folder.c_str(), W_OK) != 0)
        return "the folder " + name + " can't be written to: " + std::strerror(errno) + "; expected a writable folder";
    if (fs::exists(path, ignored) && access(path.c_str(), W_OK) != 0)
        return std::string("it can't be replaced: ") + std::strerror(errno) + "; expected a writable file";
    return {};
}

bool isSameFile(const std::string& fileName, const std::string& otherName)
{
    if (isSpecial(fileName)) return false;
    return fs::weakly_canonical(fs::absolute(fileName)) == fs::weakly_canonical(fs::absolute(otherName));
}

std::string writeCompleteFile(const std::string& fileName, const std::function<std::string(std::ostream&)>& write)
{
    if (std::string obstacle = findObstacleToWriting(fileName); !obstacle.empty()) return obstacle;
    std::error_code ignored;
    // Replace the target of a link, not the link.
    const fs::path path =
        fs::is_symlink(fileName, ignored) ? fs::weakly_canonical(fileName, ignored) : fs::path(fileName);
    if (isSpecial(path)) return writeDevice(fileName, write);
    TemporaryFile file(path.string());
    if (file.getDescriptor() < 0) return std::strerror(errno);
    std::string why = writeTo(file.getDescriptor(), write);
    return why.empty() ? file.publish() : why;
}

} // namespace osgLego
