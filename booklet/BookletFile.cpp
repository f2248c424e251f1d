#include "BookletFile.h"

#include "BookletFailure.h"

#include <common/CompleteFile.h>

#include <filesystem>
#include <optional>
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

/** @param path of the file, or of its folder. */
void check(const std::string& fileName, const std::string& path)
{
    if (const std::string obstacle = findObstacleToWriting(path); !obstacle.empty())
        throw cannotWrite(fileName, obstacle);
}

} // namespace

BookletFolder::BookletFolder(const std::string& fileName) : _folder(folderOf(fileName))
{
    if (_folder.getError()) throw cannotWrite(fileName, _folder.getError().message());
}

void checkBookletFiles(const std::vector<std::string>& fileNames)
{
    const fs::path folder = folderOf(fileNames.front());
    std::error_code ignored;
    std::optional<BookletFolder> attempt;
    if (!folder.empty() && !fs::exists(folder, ignored))
    {
        check(fileNames.front(), folder.string()); // created by the rules for a file in its place
        attempt.emplace(fileNames.front());
    }
    for (const std::string& fileName : fileNames)
        check(fileName, fileName);
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
