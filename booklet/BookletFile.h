#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace osgLego
{

/** Creates the folder of a file, and removes it if no file is written. Throws BookletFailure. */
class BookletFolder
{
public:
    explicit BookletFolder(const std::string& fileName);
    BookletFolder(const BookletFolder&) = delete;
    BookletFolder& operator=(const BookletFolder&) = delete;
    ~BookletFolder();

    void keep() { _isNew = false; }

private:
    std::string _name;
    bool _isNew = false;
};

/** Throws BookletFailure if a file can't be written in its folder, or in a new one, which is made and removed for that.
 */
void checkBookletFolder(const std::string& fileName);

/** Write a file atomically by a function that may throw. Throws BookletFailure. */
void writeBookletFile(const std::string& fileName, const std::function<void(std::ostream&)>& write);

} // namespace osgLego
