#pragma once

#include <filesystem>
#include <system_error>

namespace osgLego
{

/** Creates a folder if it does not exist, and removes it again if nothing was written into it.
 *
 *     NewFolder folder("booklets");
 *     if (folder.getError()) ... // it can't be created
 *     ... // write files
 *     folder.keep();
 *
 * One thread. */
class NewFolder
{
public:
    /** @param path of a folder in an existing one; empty for the current folder. */
    explicit NewFolder(std::filesystem::path path);
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;
    ~NewFolder();

    const std::error_code& getError() const { return _error; }
    /** Keep the folder even if it is empty. */
    void keep() { _isNew = false; }

private:
    std::filesystem::path _path;
    std::error_code _error;
    bool _isNew = false;
};

} // namespace osgLego
