#include "BookletFile.h"

#include "BookletFailure.h"

#include <common/CompleteFile.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
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
}

void writeBookletFile(const std::string& fileName, const std::function<void(std::ostream&)>& write)
{
    std::exception_ptr failure; // a temporary file is removed only if its writer returns
    const auto writeTemporary = [&](const std::string& temporaryName) -> std::string
    {
        std::ofstream file(temporaryName, std::ios::binary);
        try
        {
            if (file) write(file);
        }
        catch (...)
        {
            failure = std::current_exception();
            return "cancelled";
        }
        file.close();
        return file ? std::string() : std::string(std::strerror(errno));
    };
    const std::string why = writeCompleteFile(fileName, writeTemporary);
    if (failure) std::rethrow_exception(failure);
    if (!why.empty()) throw cannotWrite(fileName, why);
}

} // namespace osgLego
