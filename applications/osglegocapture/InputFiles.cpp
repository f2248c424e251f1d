#include "InputFiles.h"

#include "ExitCode.h"

#include <common/NameList.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <osgDB/Callbacks>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
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
        const bool isFile = !found.empty() && osgDB::fileType(found) != osgDB::DIRECTORY;
        const std::size_t scheme = fileName.find("://");
        // Some readers put the folder of the model before an address, too.
        if (!isFile && scheme != std::string::npos && fileName.find('/') < scheme) return found;
        const std::lock_guard lock(_mutex);
        (isFile ? _requested : _missing).insert(fileName);
        if (isFile) _found.insert(found);
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

    /** The names that were searched in vain. Readers search for the simple name after the path: a path is found if its
     * simple name is, and a simple name of a path is not a second file. */
    std::set<std::string> getMissing()
    {
        const std::lock_guard lock(_mutex);
        std::set<std::string> missing = _missing;
        std::erase_if(missing, [this](const std::string& name)
                      { return _requested.contains(name) || _requested.contains(osgDB::getSimpleFileName(name)); });
        std::set<std::string> simpleNames;
        for (const std::string& name : missing)
            if (osgDB::getSimpleFileName(name) != name) simpleNames.insert(osgDB::getSimpleFileName(name));
        std::erase_if(missing, [&](const std::string& name) { return simpleNames.contains(name); });
        return missing;
    }

private:
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

/** A name from a file for a message: without the folders of the machine that wrote it, and on one line. */
std::string toText(const std::string& name)
{
    std::string text = osgDB::isAbsolutePath(name) ? osgDB::getSimpleFileName(name) : name;
    std::ranges::replace_if(
        text, [](unsigned char character) { return std::iscntrl(character) != 0; }, '?');
    return text;
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
    std::set<std::string> names;
    for (const std::string& name : FindRecorder::get().getMissing())
        if (isPartOfModel(name)) names.insert(toText(name));
    if (names.empty()) return {};
    constexpr std::size_t MOST_NAMES = 10;
    return fmt::format("'{}' names {} found: {}; expected {} in its folder, or the model may lack colours", model,
                       names.size() == 1 ? "a file that was not" : "files that were not",
                       listNames(names, MOST_NAMES, [](const std::string& name) { return "'" + name + "'"; }),
                       names.size() == 1 ? "it" : "them");
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
