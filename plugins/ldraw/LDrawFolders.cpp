#include "LDrawFolders.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

std::string toLowerCase(std::string name)
{
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return name;
}

bool isFile(const std::string& path)
{
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

} // namespace

std::string LDrawFolders::findFile(const std::string& folder, const std::string& name)
{
    const fs::path steps(name);
    // Files outside the folder are never read, for any reference of a document.
    const auto leaves = [](const fs::path& step) { return step == ".." || step.is_absolute(); };
    if (std::any_of(steps.begin(), steps.end(), leaves)) return {};
    if (std::string exact = folder + "/" + name; isFile(exact)) return exact;
    std::string path = folder;
    for (const fs::path& step : steps)
    {
        if (step == ".") continue;
        path = findEntry(path, step.string());
        if (path.empty()) return {};
    }
    return isFile(path) ? path : std::string();
}

std::string LDrawFolders::findEntry(const std::string& folder, const std::string& name)
{
    std::error_code ignored;
    if (std::string exact = folder + "/" + name; !name.empty() && fs::exists(exact, ignored)) return exact;
    const Names& names = list(folder);
    const auto found = names.find(toLowerCase(name));
    return found == names.end() ? std::string() : folder + "/" + found->second;
}

const LDrawFolders::Names& LDrawFolders::list(const std::string& folder)
{
    const auto [place, isNew] = _lists.try_emplace(folder);
    Names& names = place->second;
    if (!isNew) return names;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem))
    {
        const std::string name = entry->path().filename().string();
        std::string& known = names[toLowerCase(name)];
        // Of names that differ only in case, the result must not depend on the order of the folder.
        if (known.empty() || name < known) known = name;
    }
    return names;
}

} // namespace osgLego
