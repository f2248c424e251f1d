#include "InputFiles.h"

#include "ExitCode.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <osgDB/Callbacks>
#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

namespace osgLego
{

namespace
{

/** Records what OSG finds: its readers search for each file that they open, also for those that a model names. */
class FindRecorder : public osgDB::FindFileCallback
{
public:
    static FindRecorder& get()
    {
        static const osg::ref_ptr<FindRecorder> recorder = new FindRecorder;
        return *recorder;
    }

    std::string findDataFile(const std::string& fileName, const osgDB::Options* options,
                             osgDB::CaseSensitivity sensitivity) override
    {
        std::string found = FindFileCallback::findDataFile(fileName, options, sensitivity);
        const std::lock_guard lock(_mutex);
        (found.empty() ? _missing : _requested).insert(fileName);
        if (!found.empty()) _found.insert(found);
        return found;
    }

    void add(const std::string& fileName)
    {
        const std::lock_guard lock(_mutex);
        _found.insert(fileName);
    }

    std::set<std::string> getFound()
    {
        const std::lock_guard lock(_mutex);
        return _found;
    }

    /** The names that were searched in vain, without those of which a reader has found the end in another folder. */
    std::set<std::string> getMissing()
    {
        const std::lock_guard lock(_mutex);
        std::set<std::string> missing = _missing;
        std::erase_if(missing,
                      [this](const std::string& name) {
                          return std::ranges::any_of(_requested, [&](const std::string& requested)
                                                     { return endsWith(name, requested); });
                      });
        return missing;
    }

private:
    /** Whether a path ends with another one, folder by folder. */
    static bool endsWith(const std::string& path, const std::string& end)
    {
        return path == end || path.ends_with('/' + end) || path.ends_with('\\' + end);
    }

    std::mutex _mutex;
    std::set<std::string> _found;
    std::set<std::string> _requested; // the names by which files were found
    std::set<std::string> _missing;
};

/** The extensions of material libraries and of all pictures that OpenImageIO reads. */
std::set<std::string> findExtensions()
{
    std::set<std::string> extensions{"mtl"};
    for (const auto& [format, names] : OIIO::get_extension_map())
        extensions.insert(names.begin(), names.end());
    return extensions;
}

/** Whether a name is that of a material library or a picture. Plugins try others for the model itself. */
bool isPartOfModel(const std::string& fileName)
{
    static const std::set<std::string> extensions = findExtensions();
    return extensions.contains(osgDB::getLowerCaseFileExtension(fileName));
}

} // namespace

void InputFiles::record()
{
    osgDB::Registry::instance()->setFindFileCallback(&FindRecorder::get());
}

void InputFiles::add(const std::string& fileName)
{
    FindRecorder::get().add(fileName);
}

std::string InputFiles::describeMissing(const std::string& model)
{
    const std::set<std::string> searched = FindRecorder::get().getMissing();
    std::set<std::string> missing;
    for (const std::string& name : searched)
        if (isPartOfModel(name)) missing.insert("'" + osgDB::getSimpleFileName(name) + "'");
    if (missing.empty()) return {};
    return fmt::format("'{}' names {} found: {}; expected {} in its folder, or the model may lack colours", model,
                       missing.size() == 1 ? "a file that was not" : "files that were not", fmt::join(missing, ", "),
                       missing.size() == 1 ? "it" : "them");
}

void InputFiles::checkAreKept(const std::vector<std::string>& outputs)
{
    namespace fs = std::filesystem;
    for (const std::string& input : FindRecorder::get().getFound())
        for (const std::string& output : outputs)
        {
            std::error_code ignored; // an output that does not exist replaces nothing
            if (fs::is_regular_file(output, ignored) && fs::equivalent(output, input, ignored))
                throw CaptureError(EXIT_BAD_OUTPUT,
                                   fmt::format("can't write '{}': it would take the place of a file that is read; "
                                               "expected another name, or another folder",
                                               output));
        }
}

} // namespace osgLego
