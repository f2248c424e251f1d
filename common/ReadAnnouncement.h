#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include <osgDB/FileUtils>

namespace osgLego
{

/** Tell the application's FindFileCallback that a file is read that was found without OSG's search. The path is made
 * absolute, since OSG would search for relative ones in other folders first. */
inline void announceReading(const std::string& path, const osgDB::Options* options = nullptr)
{
    std::error_code ignored;
    osgDB::findDataFile(std::filesystem::absolute(path, ignored).string(), options);
}

} // namespace osgLego
