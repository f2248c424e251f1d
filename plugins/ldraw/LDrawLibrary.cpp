#include "LDrawLibrary.h"

#include <common/ReadableFile.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <osgDB/FileUtils>

namespace osgLego
{

namespace
{

/** The path of a file below a folder, in any case; empty if there is none. */
std::string findBelow(const std::string& folder, const std::string& name)
{
    std::string path = folder;
    for (const std::filesystem::path& step : std::filesystem::path(name))
    {
        // Files outside the folder are never read, whatever a document refers to.
        if (step == ".." || step.is_absolute()) return {};
        path = osgDB::findFileInDirectory(step.string(), path, osgDB::CASE_INSENSITIVE);
        if (path.empty()) return {};
    }
    return osgDB::fileType(path) == osgDB::REGULAR_FILE ? path : std::string();
}

} // namespace

LDrawLibrary::LDrawLibrary(const std::string& modelFolder, const std::string& libraryFolder) :
    _libraryFolder(libraryFolder)
{
    _folders.push_back(modelFolder.empty() ? "." : modelFolder);
    if (libraryFolder.empty()) return;
    _hasParts = !osgDB::findFileInDirectory("parts", libraryFolder, osgDB::CASE_INSENSITIVE).empty();
    if (!_hasParts)
        _errors.push_back("there is no folder 'parts' in '" + libraryFolder +
                          "'; expected LDRAWDIR as the folder of a part library");
    for (const char* name : {"parts", "p", "models"})
    {
        const std::string folder = osgDB::findFileInDirectory(name, libraryFolder, osgDB::CASE_INSENSITIVE);
        if (!folder.empty()) _folders.push_back(folder);
    }
}

const LDrawDocument* LDrawLibrary::find(const std::string& name)
{
    const auto [place, isNew] = _documents.emplace(name, nullptr);
    if (isNew) place->second = read(name);
    return place->second.get();
}

std::unique_ptr<LDrawDocument> LDrawLibrary::read(const std::string& name)
{
    for (const std::string& folder : _folders)
    {
        const std::string path = findBelow(folder, name);
        if (path.empty()) continue;
        std::string error;
        const std::optional<std::string> text = readText(path, error);
        std::optional<LDrawDocument> document;
        if (text) document = LDrawDocument::parse(*text, error);
        if (document)
        {
            document->setDefaultName(name);
            return std::make_unique<LDrawDocument>(std::move(*document));
        }
        _errors.push_back("can't read '" + path + "': " + error);
        return nullptr;
    }
    return nullptr;
}

std::vector<LDrawColorDefinition> LDrawLibrary::readColors() const
{
    if (!_hasParts) return {};
    std::string error;
    const std::string path = findBelow(_libraryFolder, "ldconfig.ldr");
    const std::optional<std::string> text = path.empty() ? std::nullopt : readText(path, error);
    const std::optional<LDrawDocument> document = text ? LDrawDocument::parse(*text, error) : std::nullopt;
    return document ? document->getColors() : std::vector<LDrawColorDefinition>();
}

std::optional<std::string> readText(const std::string& path, std::string& error)
{
    error = findObstacleToReading(path);
    if (!error.empty()) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), {});
    if (file.bad()) error = std::strerror(errno);
    if (!error.empty()) return std::nullopt;
    return text;
}

} // namespace osgLego
