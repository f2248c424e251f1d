#include "BookletFile.h"

#include "BookletFailure.h"

#include <common/CompleteFile.h>

#include <filesystem>
#include <system_error>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

BookletFailure cannotWrite(const std::string& fileName, const std::string& why)
{
    return {BookletError::Reason::BAD_FILE, "can't write '" + fileName + "': " + why};
}

/** The folder of a file, without slashes at its end; empty for a file in the current folder. */
fs::path folderOf(const std::string& fileName)
{
    return fs::path(fileName).parent_path();
}

} // namespace

BookletFolder::BookletFolder(const std::string& fileName) : _name(folderOf(fileName).string())
{
    if (_name.empty()) return;
    std::error_code error;
    _isNew = fs::create_directory(_name, error);
    if (error) throw cannotWrite(fileName, error.message());
}

BookletFolder::~BookletFolder()
{
    std::error_code ignored;
    if (_isNew) fs::remove(_name, ignored);
}

void checkBookletFolder(const std::string& fileName)
{
    std::error_code ignored;
    const fs::path folder = folderOf(fileName);
    // A folder that does not exist yet is created by the rules for a file in its place.
    const bool isThere = folder.empty() || fs::exists(folder, ignored);
    if (const std::string obstacle = findObstacleToWriting(isThere ? fileName : folder.string()); !obstacle.empty())
        throw cannotWrite(fileName, obstacle);
    if (isThere) return;
    // Some file systems refuse folders for no reason that can be checked.
    const BookletFolder attempt(fileName);
}

void writeBookletFile(const std::string& fileName, const std::function<void(std::ostream&)>& write)
{
    const std::string why = writeCompleteFile(fileName,
                                              [&](std::ostream& stream)
                                              {
                                                  write(stream);
                                                  return std::string();
                                              });
    if (!why.empty()) throw cannotWrite(fileName, why);
}

} // namespace osgLego
