#include <common/TemporaryFile.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iomanip>
#include <random>
#include <sstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

constexpr mode_t ALLOWED = 0666; // less what the process masks
constexpr int MOST_ATTEMPTS = 100;

fs::path folderOf(const std::string& path)
{
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

/** A name in the folder of a file that cannot be guessed. Independent of the file's name, which may be as long as names
 * can be. */
std::string inventName(const std::string& path)
{
    std::random_device random;
    std::ostringstream name;
    name << '.' << std::hex << std::setfill('0') << std::setw(8) << random() << std::setw(8) << random() << ".part";
    return (fs::path(path).parent_path() / name.str()).string();
}

/** The name by which a file without a name can be linked. */
std::string descriptorName(int descriptor)
{
    return "/proc/self/fd/" + std::to_string(descriptor);
}

int openWithoutName([[maybe_unused]] const std::string& path)
{
#if defined(O_TMPFILE)
    const int descriptor = open(folderOf(path).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, ALLOWED);
    if (descriptor < 0) return descriptor;
    if (access(descriptorName(descriptor).c_str(), F_OK) == 0) return descriptor;
    close(descriptor);
#endif
    return -1;
}

} // namespace

TemporaryFile::TemporaryFile(const std::string& path) : _path(path), _descriptor(openWithoutName(path))
{
    // Until it has the permissions of the file that it replaces, nobody else may read it.
    const mode_t mode = access(path.c_str(), F_OK) == 0 ? 0600 : ALLOWED;
    for (int attempt = 0; _descriptor < 0 && attempt < MOST_ATTEMPTS; ++attempt)
    {
        _name = inventName(_path);
        _descriptor = open(_name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode);
        if (_descriptor < 0 && errno != EEXIST) break;
    }
    if (_descriptor < 0) _name.clear();
}

TemporaryFile::~TemporaryFile()
{
    if (_descriptor >= 0) close(_descriptor);
    if (!_name.empty()) unlink(_name.c_str());
}

/** Give a file without a name one. @return false with errno if that fails. */
bool TemporaryFile::link()
{
    const std::string source = descriptorName(_descriptor);
    for (int attempt = 0; attempt < MOST_ATTEMPTS; ++attempt)
    {
        const std::string name = inventName(_path);
        if (linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0)
        {
            _name = name;
            return true;
        }
        if (errno != EEXIST) return false;
    }
    return false;
}

std::string TemporaryFile::publish()
{
    // Some file systems tell only now that the disk is full. Others can't synchronize, which is no error.
    if (fsync(_descriptor) != 0 && errno != EINVAL && errno != EROFS) return std::strerror(errno);
    struct stat replaced = {};
    if (stat(_path.c_str(), &replaced) == 0)
    {
        // Only the superuser may give files away; others may choose among their groups.
        mode_t mode = replaced.st_mode & 07777;
        if (fchown(_descriptor, static_cast<uid_t>(-1), replaced.st_gid) != 0) mode &= ~mode_t(S_ISGID | S_IRWXG);
        if (fchown(_descriptor, replaced.st_uid, static_cast<gid_t>(-1)) != 0) mode &= ~mode_t(S_ISUID);
        if (fchmod(_descriptor, mode) != 0) return std::strerror(errno);
    }
    if (_name.empty() && !link()) return std::strerror(errno);
    if (std::rename(_name.c_str(), _path.c_str()) != 0) return std::strerror(errno);
    _name.clear();
    return {};
}

} // namespace osgLego
