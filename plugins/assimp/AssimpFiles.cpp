#include "AssimpFiles.h"

#include <common/ReadAnnouncement.h>

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>

AssimpFiles::AssimpFiles(const osgDB::Options& options) : _options(&options) {}

bool AssimpFiles::Exists(const char* name) const
{
    return !find(name).empty();
}

Assimp::IOStream* AssimpFiles::Open(const char* name, const char* mode)
{
    const std::string found = find(name);
    return found.empty() ? nullptr : DefaultIOSystem::Open(found.c_str(), mode);
}

std::string AssimpFiles::find(const char* name) const
{
    if (DefaultIOSystem::Exists(name))
    {
        osgLego::announceReading(name, _options);
        return name;
    }
    // Importers put the folder of the model before the name.
    for (const std::string& folder : _options->getDatabasePathList())
    {
        const std::string relative = osgDB::getPathRelative(folder, name);
        if (relative == name) continue;
        if (std::string found = osgDB::findDataFile(relative, _options); !found.empty()) return found;
    }
    return osgDB::findDataFile(name, _options);
}
