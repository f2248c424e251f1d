#include "BuildCommand.h"

#include "BookletPrinter.h"
#include "Cancellation.h"
#include "CaptureFiles.h"
#include "CaptureScene.h"
#include "ExitCode.h"
#include "Instructions.h"
#include "ProgressBar.h"
#include "ScenePicture.h"

#include <common/PictureBuffer.h>
#include <osgLego/ModelDesigner.h>
#include <osgLegoBooklet/Booklet.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

/** The names of the files of a model. */
class BuildFiles
{
public:
    explicit BuildFiles(const CaptureOptions& options) :
        _folder(options.build), _name(options.mesh.empty() ? "racing-car" : nameBooklet(options.mesh))
    {
    }

    /** @param ending such as ".png". */
    std::string get(const std::string& ending) const { return (_folder / (_name + ending)).string(); }

    /** Throws CaptureError if one of the files can't be written. */
    void check(const CaptureOptions& options) const
    {
        checkInstructionsPlace(options); // the folder, too
        std::error_code error;
        if (!std::filesystem::exists(_folder, error)) return;
        for (const char* ending : {".png", ".pdf", ".mpd", ".csv", ".xml", "-report.txt"})
            checkPlace(get(ending));
    }

private:
    std::filesystem::path _folder;
    std::string _name;
};

/** Choose the best model. */
ModelDesign design(const CaptureOptions& options, LegoNode& lego, const ProgressBar& progress)
{
    DesignOptions goals;
    goals.settings = options.settingsText;
    if (options.buildParts) goals.numParts = *options.buildParts;
    goals.length = options.buildLength;
    goals.base = options.base.value_or(BuildingBase::TABLE);
    goals.isCancelled = Cancellation::isRequested;
    goals.progress = [&progress](double share) { progress.show(share, "trying settings"); };
    std::string error;
    std::optional<ModelDesign> design = designModel(*lego.getChild(0), goals, error);
    progress.clear();
    Cancellation::check("cancelled; nothing was written");
    if (!design) throw CaptureError(EXIT_BAD_INPUT, error);
    return std::move(*design);
}

std::string describeDefects(const DesignCandidate& best)
{
    if (!best.isWhole())
        return fmt::format("the model has {} pieces; expected a mesh that is one piece, or more parts",
                           best.layout.numComponents);
    if (best.stability.falls())
        return fmt::format("{} of {} parts fall; expected a mesh that stands, --base plate, or more parts",
                           best.stability.falling.size(), best.layout.numParts);
    return best.stability.stands ? "" : "it is unknown whether the model stands";
}

void drawInto(const CaptureOptions& options, const CaptureScene& scene, const std::string& file,
              osg::GraphicsContext& context, const ProgressBar& progress)
{
    progress.show("drawing");
    ScenePicture picture(options, scene, context);
    OIIO::ImageBuf image;
    {
        const Cancellation::Unasked unasked;
        image = toImageBuf(*picture.draw());
    }
    writePicture(file, image);
}

} // namespace

void buildModel(const CaptureOptions& given, osg::GraphicsContext& context)
{
    CaptureOptions options = given;
    options.instructions = options.build;
    const BuildFiles files(options);
    files.check(options);

    const Cancellation cancellation;
    const ProgressBar progress;
    progress.show("reading");
    const CaptureScene scene(options);
    LegoNode& lego = scene.getOnlyLegoNode();
    const ModelDesign choice = design(options, lego, progress);
    const DesignCandidate& best = choice.getBest();
    lego.setSettings(best.settings);
    lego.setStoredBricks(best.model);
    checkInstructionsSize(options, lego);

    writeInstructions(options, lego, best.stability, context, progress);
    drawInto(options, scene, files.get(".png"), context, progress);
    progress.show("printing the booklet");
    const std::string unprinted = printBooklet(files.get(".html"), files.get(".pdf"));
    const std::string report = choice.toString();
    writeText(files.get("-report.txt"), [&](std::ostream& stream) { stream << report; });
    progress.clear();

    fmt::print("{}\n", report);
    fmt::print("wrote '{}' and, with other endings, .html, .txt, {}.mpd, .csv, .xml and -report.txt\n",
               files.get(".png"), unprinted.empty() ? ".pdf, " : "");
    std::fflush(stdout); // before the warnings, where both are the same file
    if (!unprinted.empty()) fmt::print(stderr, "osglegocapture: warning: there is no PDF: {}\n", unprinted);
    if (const std::string defects = describeDefects(best); !defects.empty())
        fmt::print(stderr, "osglegocapture: warning: {}\n", defects);
}

} // namespace osgLego
