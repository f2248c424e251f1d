#include "LDrawLibrary.h"

#include "LDrawParser.h"
#include "LDrawText.h"

#include <common/ReadAnnouncement.h>

namespace osgLego
{

namespace
{

std::optional<std::string> readAnnouncedText(const std::string& path, std::string& error)
{
    announceReading(path);
    return readText(path, error);
}

} // namespace

LDrawLibrary::LDrawLibrary(const std::string& modelFolder, const std::string& libraryFolder) :
    _libraryFolder(libraryFolder)
{
    _folders.push_back(modelFolder.empty() ? "." : modelFolder);
    if (libraryFolder.empty()) return;
    _hasParts = !_lookup.findEntry(libraryFolder, "parts").empty();
    if (!_hasParts)
        _errors.push_back("there is no folder 'parts' in '" + libraryFolder +
                          "'; expected LDRAWDIR as the folder of a part library");
    for (const char* name : {"parts", "p", "models"})
    {
        const std::string folder = _lookup.findEntry(libraryFolder, name);
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
        const std::string path = _lookup.findFile(folder, name);
        if (path.empty()) continue;
        std::string error;
        const std::optional<std::string> text = readAnnouncedText(path, error);
        std::optional<LDrawDocument> document;
        if (text) document = LDrawParser::parse(*text, error);
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

std::vector<LDrawColorDefinition> LDrawLibrary::readColors()
{
    if (!_hasParts) return {};
    std::string error;
    const std::string path = _lookup.findFile(_libraryFolder, "ldconfig.ldr");
    const std::optional<std::string> text = path.empty() ? std::nullopt : readAnnouncedText(path, error);
    const std::optional<LDrawDocument> document = text ? LDrawParser::parse(*text, error) : std::nullopt;
    return document ? document->getColors() : std::vector<LDrawColorDefinition>();
}

} // namespace osgLego
