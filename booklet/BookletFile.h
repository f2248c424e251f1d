#pragma once

#include <common/NewFolder.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace osgLego
{

/** Creates the folder of a file, and removes it if no file is written. Throws BookletFailure. */
class BookletFolder
{
public:
    explicit BookletFolder(const std::string& fileName);

    void keep() { _folder.keep(); }

private:
    NewFolder _folder;
};

/** Throws BookletFailure if files can't be written in their folder, or in a new one, which is made and removed for
 * that.
 * @param fileNames of one folder. */
void checkBookletFiles(const std::vector<std::string>& fileNames);

/** Write a file atomically by a function that may throw. Throws BookletFailure. */
void writeBookletFile(const std::string& fileName, const std::function<void(std::ostream&)>& write);

} // namespace osgLego
