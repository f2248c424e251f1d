#include "ReferenceShaders.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string_view>

namespace osgLego
{

/** The files by name; generated at build time, see CMakeLists.txt. */
const std::map<std::string_view, std::string_view>& getReferenceShaders();

namespace
{

constexpr const char* VARIABLE = "OSGLEGO_SHADER_PATH";

} // namespace

ReferenceShaders::ReferenceShaders() : _folder(std::filesystem::temp_directory_path() / "osglegobench-XXXXXX")
{
    if (!mkdtemp(_folder.data())) throw std::runtime_error("can't create a temporary folder '" + _folder + "'");
    for (const auto& [name, text] : getReferenceShaders())
    {
        const std::filesystem::path path = std::filesystem::path(_folder) / name;
        std::error_code ignored;
        std::filesystem::create_directories(path.parent_path(), ignored);
        if ((std::ofstream(path, std::ios::binary) << text).flush()) continue;
        std::filesystem::remove_all(_folder, ignored);
        throw std::runtime_error("can't write '" + path.string() + "'");
    }
    if (const char* path = std::getenv(VARIABLE)) _formerPath = path;
    setenv(VARIABLE, _folder.c_str(), 1);
}

ReferenceShaders::~ReferenceShaders()
{
    if (_formerPath)
        setenv(VARIABLE, _formerPath->c_str(), 1);
    else
        unsetenv(VARIABLE);
    std::error_code ignored;
    std::filesystem::remove_all(_folder, ignored);
}

} // namespace osgLego
