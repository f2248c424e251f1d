#pragma once

#include <string>
#include <unordered_map>

namespace osgLego
{

/** Finds files below folders, in any case. Each folder is listed once, and only if it lacks the exact name, so that
 * thousands of names can be looked up beside thousands of files. Later changes of names' case are not noticed.
 *
 * One thread. */
class LDrawFolders
{
public:
    /** The path of a file below a folder; empty if there is none. The name may contain folders; the exact name is
     * preferred. Files outside the folder are never found. */
    std::string findFile(const std::string& folder, const std::string& name);
    /** The path of a file or a folder directly in a folder; empty if there is none. */
    std::string findEntry(const std::string& folder, const std::string& name);

private:
    using Names = std::unordered_map<std::string, std::string>; // by the name in lower case

    const Names& list(const std::string& folder);

    std::unordered_map<std::string, Names> _lists; // by the folder
};

} // namespace osgLego
