#pragma once

#include <string>

namespace osgLego
{

/** A file under construction in the folder of the one that it will replace. It has no name where the file system allows
 * that, so that nothing is left of it even if the process is killed; otherwise, a random name that nobody had. Not
 * thread-safe. */
class TemporaryFile
{
public:
    /** @param path that of a file or of none, not of a link, device or folder. */
    explicit TemporaryFile(const std::string& path);
    /** Removes the file unless it took its place. */
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /** Open for writing, or -1 with errno. */
    int getDescriptor() const { return _descriptor; }
    /** Take the place of the file with the path, with its permissions and, if possible, its owner. Call it once.
     * @return the reason if that fails, after which an older file is unchanged; otherwise, an empty text. */
    std::string publish();

private:
    bool link();

    std::string _path;
    std::string _name; //!< empty if it has none
    int _descriptor = -1;
};

} // namespace osgLego
