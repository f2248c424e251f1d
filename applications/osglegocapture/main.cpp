#include "BrickMaking.h"
#include "BuildCommand.h"
#include "Cancellation.h"
#include "CaptureFiles.h"
#include "CaptureOptions.h"
#include "CaptureScene.h"
#include "Comparison.h"
#include "ExitCode.h"
#include "InputFiles.h"
#include "Instructions.h"
#include "LocalReading.h"
#include "ModelBound.h"
#include "ProgressBar.h"
#include "ScenePicture.h"
#include "SceneReading.h"
#include "SceneStability.h"
#include "StandardError.h"
#include "StandardOutput.h"
#include "StatisticsFile.h"
#include "ThreadSupply.h"

#include <common/PictureBuffer.h>
#include <offscreen/OffscreenContext.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <osgDB/Registry>
#include <unistd.h>

namespace osgLego
{

namespace
{

/** The file for the difference to a reference: next to the output or, without an output, in the current folder. */
std::string differenceNameOf(const CaptureOptions& options)
{
    const std::filesystem::path path(options.output.empty() ? std::filesystem::path(options.reference).filename()
                                                            : std::filesystem::path(options.output));
    return (path.parent_path() / (path.stem().string() + "-difference.png")).string();
}

/** Warn before a picture takes gigabytes: if memory is short, the machine may swap or kill the program. */
void warnOfMemory(const CaptureScene& scene, const CaptureOptions& options)
{
    constexpr double GIGABYTE = 1e9;
    constexpr double NOTABLE = 2.0 * GIGABYTE;
    const double bytes = ScenePicture::estimateMemory(options, scene);
    if (bytes < NOTABLE) return;
    printError("osglegocapture: warning: drawing {} x {} pixels takes about {:.0f} GB of memory; a smaller --size {}\n",
               options.width, options.height, bytes / GIGABYTE,
               options.hasOcclusion ? "and --occlusion off take less" : "takes less");
}

/** Compute the fewest bricks, or warn if there are none to count. */
void addBound(const LegoNode& lego, std::optional<LayoutStatistics>& layout, const ProgressBar& progress)
{
    progress.show("computing the fewest bricks");
    const std::size_t bound = layout ? computeModelBound(lego) : 0;
    progress.clear();
    if (bound > 0)
        layout->lowerBound = bound;
    else
        printError("osglegocapture: warning: --bound has nothing to count; expected a mesh in parts=bricks and "
                   "proportions=brick\n");
}

/** Print the figures of parts. @return nothing if there are no parts. */
std::optional<LayoutStatistics> reportLayout(const CaptureOptions& options, const CaptureScene& scene,
                                             osg::GraphicsContext& context, const ProgressBar& progress)
{
    const LegoNode* lego = scene.getLegoNode();
    if (!lego) return std::nullopt;
    std::optional<LayoutStatistics> layout = lego->getStatistics(context.getState()->getContextID()).layout;
    progress.clear();
    if (options.bound) addBound(*lego, layout, progress);
    if (!layout) return std::nullopt;
    fmt::print("{}\n", layout->toString());
    return layout;
}

OIIO::ImageBuf draw(const CaptureOptions& options, ScenePicture& picture, const ProgressBar& progress)
{
    progress.show(options.original ? "drawing" : "legolizing and drawing");
    const Cancellation::Unasked unasked;
    return toImageBuf(*picture.draw());
}

/** Draw, and write everything that comes with a picture. */
int drawAndWrite(const CaptureOptions& options, const CaptureScene& scene, const SceneStability* stability,
                 const StandardOutput* standardOutput, const OIIO::ImageBuf& reference, osg::GraphicsContext& context,
                 const ProgressBar& progress)
{
    warnOfMemory(scene, options);
    ScenePicture picture(options, scene, context); // keeps the bricks in the context
    const OIIO::ImageBuf image = draw(options, picture, progress);
    Cancellation::check("cancelled before the picture was written");
    progress.show("writing");
    if (!options.output.empty()) writePicture(options.output, image);
    Cancellation::check();
    const std::optional<LayoutStatistics> layout = reportLayout(options, scene, context, progress);
    const CaptureStatistics statistics{scene, picture, layout, stability};
    const auto write = [&](std::ostream& stream) { writeStatistics(stream, statistics, context); };
    if (options.statistics == CaptureOptions::STANDARD_OUTPUT)
        standardOutput->write(write);
    else if (!options.statistics.empty())
        writeText(options.statistics, write);
    if (!options.cells.empty())
        writeCells(options.cells, *scene.getLegoNode()->getBricks(context.getState()->getContextID()));
    progress.clear();
    if (options.reference.empty()) return EXIT_FINE;
    return compareWithReference(image, reference, options.threshold, differenceNameOf(options)) ? EXIT_FINE
                                                                                                : EXIT_DIFFERENT;
}

void writePartsList(const CaptureOptions& options, const CaptureScene& scene, const StandardOutput* standardOutput)
{
    const PartsList list = scene.createPartsList();
    if (options.partsList == CaptureOptions::STANDARD_OUTPUT)
        standardOutput->write([&list](std::ostream& stream) { list.writeCsv(stream); });
    else
        writePartsList(options.partsList, list);
    for (const std::string& warning : {list.describeNeverMade(), list.describeWithoutNumber()})
        if (!warning.empty()) printError("osglegocapture: warning: {}\n", warning);
}

/** Compute and print whether the parts stand, if the options request it. */
std::optional<SceneStability> reportStability(const CaptureOptions& options, const CaptureScene& scene,
                                              const ProgressBar& progress)
{
    if (!options.base) return std::nullopt;
    progress.show("computing stability");
    SceneStability stability(scene.findPartModels(), options, progress);
    progress.clear();
    fmt::print("{}", stability.toText());
    return stability;
}

/** The name of a file; empty if the text is written to standard output. */
std::string toFileName(const std::string& name)
{
    return name == CaptureOptions::STANDARD_OUTPUT ? std::string() : name;
}

/** The names of all files that may be written; some are empty. */
std::vector<std::string> getOutputs(const CaptureOptions& options)
{
    std::vector<std::string> outputs{options.output, toFileName(options.statistics), options.cells,
                                     toFileName(options.partsList)};
    if (!options.reference.empty()) outputs.push_back(differenceNameOf(options));
    if (!options.instructions.empty())
        for (const std::string& file : getInstructionsFiles(options))
            outputs.push_back(file);
    return outputs;
}

/** Throws CaptureError if an output can't be written. Called before the work, which may take long. */
void checkPlaces(const CaptureOptions& options)
{
    checkPicturePlace(options.output, options.transparent);
    checkPlace(toFileName(options.statistics));
    checkPlace(options.cells);
    checkPartsListPlace(toFileName(options.partsList));
    if (!options.instructions.empty()) checkInstructionsPlace(options);
    checkAreDistinct(getOutputs(options));
}

/** @return an empty picture without --compare. */
OIIO::ImageBuf findReference(const CaptureOptions& options)
{
    if (options.reference.empty()) return {};
    std::error_code ignored;
    if (std::filesystem::equivalent(options.reference, options.output, ignored))
        throw CaptureError(EXIT_BAD_OUTPUT, "the output would take the place of the reference '" + options.reference +
                                                "'; expected another name");
    InputFiles::add(options.reference);
    checkPicturePlace(differenceNameOf(options), false);
    return readReference(options.reference, options.width, options.height);
}

/** Throws CaptureError if parts are needed that no settings give. */
void checkParts(const CaptureOptions& options, const CaptureScene& scene)
{
    if (!options.partsList.empty()) scene.checkHasParts(CaptureScene::TO_LIST);
    if (options.base) scene.checkHasParts(CaptureScene::TO_STAND);
    if (options.instructions.empty()) return;
    scene.getOnlyLegoNode();
    scene.checkHasParts(CaptureScene::TO_BUILD);
}

/** Read the scene, and make its parts. */
std::unique_ptr<CaptureScene> prepareScene(const CaptureOptions& options, const ProgressBar& progress)
{
    std::unique_ptr<CaptureScene> scene = readScene(options, progress);
    InputFiles::checkAreKept(getOutputs(options));
    checkParts(options, *scene);
    // Also for pictures: laying parts takes longest, and can be cancelled.
    for (LegoNode* lego : scene->findLegoNodes())
        if (lego->getSettings().parts.set != PartSet::NONE) makeBricks(*lego, progress);
    progress.clear();
    return scene;
}

/** @param context null if nothing is drawn. */
int capture(const CaptureOptions& options, const osg::ref_ptr<osg::GraphicsContext>& context)
{
    std::optional<StandardOutput> standardOutput;
    if (options.statistics == CaptureOptions::STANDARD_OUTPUT || options.partsList == CaptureOptions::STANDARD_OUTPUT)
        standardOutput.emplace();
    const StandardOutput* output = standardOutput ? &*standardOutput : nullptr;
    checkPlaces(options);
    const OIIO::ImageBuf reference = findReference(options);

    const Cancellation cancellation;
    const ProgressBar progress;
    const std::unique_ptr<CaptureScene> scene = prepareScene(options, progress);
    if (!options.instructions.empty()) checkInstructionsSize(options, scene->getOnlyLegoNode());
    if (!options.partsList.empty()) writePartsList(options, *scene, output);
    const std::optional<SceneStability> stability = reportStability(options, *scene, progress);
    int code = EXIT_FINE;
    if (options.needsContext())
        code = drawAndWrite(options, *scene, stability ? &*stability : nullptr, output, reference, *context, progress);
    if (!options.instructions.empty())
        // A booklet is about the model without loads.
        writeInstructions(options, scene->getOnlyLegoNode(),
                          {stability && options.loads.empty() ? stability->getReport() : std::nullopt, nullptr},
                          *context, progress);
    Cancellation::check(); // during the last output, too
    return code;
}

/** Continue as the program that is linked with OSMesa instead of EGL, since a process can use only one of them.
 * @return the path of the program, if there is none: OSMesa is optional */
[[maybe_unused]] std::string becomeOsMesa(char** argv)
{
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    std::string other = self.string() + "-osmesa";
    execv(other.c_str(), argv);
    return other;
}

/** Create the context that is drawn in, or continue as the program that can. @return null if nothing is drawn. */
osg::ref_ptr<osg::GraphicsContext> createContextFor(const CaptureOptions& options, [[maybe_unused]] char** argv)
{
    if (!options.needsContext() && options.instructions.empty() && options.build.empty()) return nullptr;
#if !defined(OSGLEGO_OSMESA)
    if (options.context == ContextKind::OSMESA)
        throw CaptureError(EXIT_NO_GL, "there is no '" + becomeOsMesa(argv) +
                                           "' to create an OSMesa context; expected --context egl");
#endif
    constexpr int UNUSED_SIZE = 16; // pictures have their own frame buffers
    std::string error;
    osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(UNUSED_SIZE, UNUSED_SIZE, error);
#if !defined(OSGLEGO_OSMESA)
    if (!context && options.context == ContextKind::AUTO) becomeOsMesa(argv);
#endif
    if (!context) throw CaptureError(EXIT_NO_GL, error);
    return context;
}

/** Let OSG find the plugins of the build or installation that contains this program. */
void findOwnPlugins()
{
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path tree = self.parent_path().parent_path();
    osgDB::FilePathList& folders = osgDB::Registry::instance()->getLibraryFilePathList();
    for (const char* folder : {"lib", OSGLEGO_LIBRARY_FOLDER})
        if (std::filesystem::is_directory(tree / folder, error)) folders.push_back((tree / folder).string());
}

/** Throws CaptureError if something printed could not be written. */
void checkPrinted()
{
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw CaptureError(EXIT_BAD_OUTPUT, std::string("can't write to standard output: ") + std::strerror(errno));
}

/** Occupy closed standard streams, so that no file that is opened later takes their place and receives their messages.
 * What is written to them still fails. */
void keepStandardStreams()
{
    int descriptor = 0;
    while (descriptor >= 0 && descriptor <= STDERR_FILENO)
        descriptor = open("/dev/null", O_RDONLY); // without O_CLOEXEC, since another program may continue
    if (descriptor > STDERR_FILENO) close(descriptor);
}

int run(int argc, char** argv)
{
    keepStandardStreams();
    std::signal(SIGXFSZ, SIG_IGN); // a file that becomes too large is an error of writing,
    std::signal(SIGPIPE, SIG_IGN); // and so is a pipe that nobody reads
    adaptToThreadSupply();
    findOwnPlugins();
    keepReadingLocal();
    InputFiles::record();
    CaptureOptions options;
    if (const std::optional<int> code = readOptions(argc, argv, options))
    {
        checkPrinted();
        return *code;
    }
    if (!options.build.empty())
    {
        buildModel(options, *createContextFor(options, argv));
        checkPrinted();
        return EXIT_FINE;
    }
    const int code = capture(options, createContextFor(options, argv));
    checkPrinted();
    return code;
}

} // namespace

} // namespace osgLego

int main(int argc, char** argv)
{
    try
    {
        return osgLego::run(argc, argv);
    }
    catch (const osgLego::CaptureError& error)
    {
        osgLego::printError("osglegocapture: {}\n", error.what());
        return error.getCode();
    }
    catch (const std::bad_alloc&)
    {
        osgLego::printError("osglegocapture: out of memory; expected a lower resolution, or a smaller picture\n");
        return osgLego::EXIT_BAD_INPUT;
    }
    catch (const std::system_error& error)
    {
        if (std::ferror(stdout) != 0)
        {
            osgLego::printError("osglegocapture: can't write to standard output: {}\n", error.code().message());
            return osgLego::EXIT_BAD_OUTPUT;
        }
        const bool isThread = error.code() == std::errc::resource_unavailable_try_again;
        osgLego::printError("osglegocapture: {}\n",
                            isThread
                                ? "the system can't start a thread; expected higher limits of processes and of memory"
                                : error.what());
        return osgLego::EXIT_BAD_INPUT;
    }
    catch (const std::exception& error)
    {
        osgLego::printError("osglegocapture: {}\n", error.what());
        return osgLego::EXIT_BAD_INPUT;
    }
}
