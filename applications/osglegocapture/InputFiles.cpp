#include "InputFiles.h"

#include "ExitCode.h"

#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

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
        if (found.empty())
        {
            const std::lock_guard lock(_mutex);
            _missing.insert(fileName);
        }
        else
            add(found);
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

    std::set<std::string> getMissing()
    {
        const std::lock_guard lock(_mutex);
        return _missing;
    }

private:
    std::mutex _mutex;
    std::set<std::string> _found;
    std::set<std::string> _missing;
};

/** Whether a name is that of a material library or a picture, rather than of a model, for which plugins have several
 * names. */
bool isPartOfModel(const std::string& fileName)
{
    static const std::set<std::string> extensions{"bmp", "dds", "exr",  "gif", "hdr", "jpeg", "jpg", "mtl",
                                                  "png", "rgb", "rgba", "sgi", "tga", "tif",  "tiff"};
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
    // Readers try several folders.
    std::set<std::string> found;
    for (const std::string& fileName : FindRecorder::get().getFound())
        found.insert(osgDB::getSimpleFileName(fileName));
    std::set<std::string> missing;
    for (const std::string& fileName : FindRecorder::get().getMissing())
        if (const std::string name = osgDB::getSimpleFileName(fileName); isPartOfModel(name) && !found.contains(name))
            missing.insert("'" + name + "'");
    if (missing.empty()) return {};
    return fmt::format("'{}' names {}, which {} not there; its colours may be missing", model, fmt::join(missing, ", "),
                       missing.size() == 1 ? "is" : "are");
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
