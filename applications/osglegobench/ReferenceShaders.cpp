#include "ReferenceShaders.h"

#include "BenchFiles.h"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string_view>

namespace osgLego
{

/** The files by name; made at build time, see CMakeLists.txt. */
const std::map<std::string_view, std::string_view>& getReferenceShaders();

namespace
{

constexpr const char* VARIABLE = "OSGLEGO_SHADER_PATH";

} // namespace

ReferenceShaders::ReferenceShaders() : _folder(std::filesystem::temp_directory_path() / "osglegobench-XXXXXX")
{
    if (!mkdtemp(_folder.data())) throw std::runtime_error("can't make a temporary folder '" + _folder + "'");
    try
    {
        for (const auto& [name, text] : getReferenceShaders())
        {
            const std::filesystem::path path = std::filesystem::path(_folder) / name;
            std::filesystem::create_directories(path.parent_path());
            writeTextFile(path, std::string(text));
        }
    }
    catch (...)
    {
        removeFolder();
        throw;
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
    removeFolder();
}

void ReferenceShaders::removeFolder() const
{
    std::error_code ignored;
    std::filesystem::remove_all(_folder, ignored);
}

} // namespace osgLego
