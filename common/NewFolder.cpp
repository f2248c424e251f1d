#include <common/NewFolder.h>

#include <utility>

namespace osgLego
{

NewFolder::NewFolder(std::filesystem::path path) : _path(std::move(path))
{
    if (!_path.empty()) _isNew = std::filesystem::create_directory(_path, _error);
}

NewFolder::~NewFolder()
{
    std::error_code ignored;
    if (_isNew) std::filesystem::remove(_path, ignored);
}

} // namespace osgLego
