#include <common/ReadableFile.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace osgLego
{

std::string findObstacleToReading(const std::string& fileName)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(fileName, ignored)) return "it is a folder; expected a file";
    if (access(fileName.c_str(), R_OK) == 0) return {};
    if (errno == ENOENT) return "there is no such file";
    return std::error_code(errno, std::generic_category()).message();
}

} // namespace osgLego
