#include "ModelSize.h"

#include "StandardError.h"

#include <filesystem>
#include <system_error>

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>

namespace osgLego
{

std::uintmax_t findModelSize(std::string fileName)
{
    while (!fileName.empty())
    {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(osgDB::findDataFile(fileName), error);
        if (!error) return size;
        const std::string shorter = osgDB::getNameLessExtension(fileName);
        if (shorter == fileName) break;
        fileName = shorter;
    }
    return 0;
}

void warnOfModelSize(const std::string& fileName)
{
    constexpr double GIGABYTE = 1e9;
    constexpr double NOTABLE = 2.0 * GIGABYTE;
    constexpr double MEMORY_PER_BYTE = 21.0; // of a binary PLY file, the densest of the usual formats
    const auto size = static_cast<double>(findModelSize(fileName));
    if (size * MEMORY_PER_BYTE < NOTABLE) return;
    printError("osglegocapture: warning: reading '{}' may take {:.0f} GB of memory and minutes; Ctrl+C cancels it\n",
               fileName, size * MEMORY_PER_BYTE / GIGABYTE);
}

} // namespace osgLego
