#include "BuildCommand.h"

#include "BookletPrinter.h"
#include "Cancellation.h"
#include "CaptureFiles.h"
#include "CaptureScene.h"
#include "ExitCode.h"
#include "InputFiles.h"
#include "Instructions.h"
#include "ProgressBar.h"
#include "ScenePicture.h"
#include "SceneReading.h"
#include "StandardError.h"

#include <common/NewFolder.h>
#include <common/NumberText.h>
#include <common/PictureBuffer.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/ModelDesigner.h>
#include <osgLego/data/BuildingLimits.h>
#include <osgLego/text/CountedNoun.h>
#include <osgLegoBooklet/Booklet.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

constexpr double STUD_PITCH = 8.0;   // millimetres
constexpr double DESIGN_SHARE = 0.8; // of the time; the booklet takes the rest

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
        const NewFolder folder(_folder); // a trial folder, so that the names of files in it can be checked
        checkInstructionsPlace(options);
        for (const std::string& file : getAll())
            checkPlace(file);
    }

    /** Throws CaptureError if one of the files has been read. */
    void checkReplaceNoInput() const { InputFiles::checkAreKept(getAll()); }

private:
    std::vector<std::string> getAll() const
    {
        std::vector<std::string> all;
        for (const char* ending : {".html", ".txt", ".png", ".pdf", ".mpd", ".csv", ".xml", "-report.txt"})
            all.push_back(get(ending));
        return all;
    }

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
    goals.view = getInstructionsView(options);
    goals.isCancelled = Cancellation::isRequested;
    goals.progress = [&progress](double share) { progress.show(share, "trying settings"); };
    std::string error;
    std::optional<ModelDesign> design = designModel(*lego.getChild(0), goals, error);
    progress.clear();
    Cancellation::check("cancelled; nothing was written");
    if (!design) throw CaptureError(EXIT_BAD_INPUT, error);
    return std::move(*design);
}

/** Throws CaptureError if a length gives a very large booklet, unless the options want it: before the search, which
 * takes long. The parts are counted in a draft of one of the models. */
void checkLength(const CaptureOptions& options, const LegoNode& lego)
{
    constexpr std::size_t CLEARLY_MORE = CaptureOptions::MOST_PARTS_UNASKED * 5 / 4; // drafts have more parts
    if (!options.buildLength || options.isBookletConfirmed) return;
    LegoSettings draft = lego.getSettings();
    draft.grid.resolution = static_cast<unsigned int>(std::lround(*options.buildLength / STUD_PITCH));
    draft.parts.set = PartSet::BRICKS;
    draft.parts.effort = Effort::INSTANT;
    const osg::ref_ptr<const BrickModel> model =
        legolizeOnCpu(*lego.getChild(0), draft, nullptr, [](double) { return !Cancellation::isRequested(); });
    Cancellation::check("cancelled; nothing was written");
    const std::size_t numParts = model ? model->getParts().size() : 0;
    if (numParts <= CLEARLY_MORE) return;
    throw CaptureError(EXIT_BAD_INPUT,
                       fmt::format("a model of this --length has about {} parts; expected --yes to build "
                                   "more than {}, or a shorter one",
                                   formatNumber(numParts), formatNumber(CaptureOptions::MOST_PARTS_UNASKED)));
}

/** The mesh and the goals, for the report. */
std::string describeGoals(const CaptureOptions& options, const ModelDesign& choice)
{
    std::string goals = "wanted: a model of " + (options.mesh.empty() ? "the built-in mesh" : options.mesh);
    if (options.buildLength) goals += fmt::format(", {:g} cm along its longest side", *options.buildLength / 10.0);
    if (choice.mostParts) goals += ", of at most " + counted(*choice.mostParts, "part", "parts");
    if (!options.settingsText.empty()) goals += ", with the settings " + options.settingsText;
    const bool isZ = choice.getBest().settings.grid.upAxis == UpAxis::Z;
    goals += fmt::format(", with its {} axis upwards", isZ ? "Z" : "Y");
    if (!options.mesh.empty()) goals += fmt::format(" (--legolize up={} if it lies on its side)", isZ ? "y" : "z");
    return goals + (options.base == BuildingBase::PLATE ? ", on a base plate" : ", on a table");
}

std::vector<std::string> describeDefects(const DesignCandidate& best, const CaptureOptions& options)
{
    constexpr double HARDLY_LIKE = 12.0; // models that show the mesh have less, also those of 60 parts
    std::vector<std::string> defects;
    if (best.getError() > HARDLY_LIKE)
        defects.push_back(
            fmt::format("the model is hardly like the mesh: its unlikeness is {:.1f}; expected at most {:g}",
                        best.getError(), HARDLY_LIKE));
    if (options.buildParts && best.layout.numParts > *options.buildParts)
        defects.push_back(fmt::format("the model has {} parts, more than the {} of --parts", best.layout.numParts,
                                      *options.buildParts));
    const char* standing = best.isWhole() ? "the model stands" : "its pieces stand";
    if (!best.isWhole())
        defects.push_back(fmt::format("the model has {} pieces{}", best.numPieces,
                                      options.base != BuildingBase::PLATE && best.stability.stands
                                          ? "; with --base plate, a plate joins those that stand on it"
                                          : ""));
    if (best.stability.tips())
        defects.push_back(fmt::format("{} tips over: its centre of mass is not above its foot on the table",
                                      best.isWhole() ? "the model" : "a piece"));
    else if (best.stability.falls())
        defects.push_back(fmt::format("{} of {} parts fall", best.stability.falling.size(), best.layout.numParts));
    else if (!best.stability.stands)
        defects.push_back(fmt::format("it is unknown whether {}", standing));
    else if (best.stability.tipsEasily())
        defects.push_back(fmt::format("{}, but {} over on a table that is tilted by {:.1f} degrees", standing,
                                      best.isWhole() ? "tips" : "one tips", *best.stability.tippingAngle));
    else if (!best.stability.safe)
        defects.push_back(fmt::format("{}, but not safely", standing));
    if (best.plan && best.exceedsLimits())
        defects.push_back("the model is hard to build: " + describeExcess(best.plan->getLargestSubmodel(),
                                                                          best.plan->getDeepestSubmodel(),
                                                                          best.plan->getNumFalling()));
    return defects;
}

void drawInto(const CaptureOptions& given, const CaptureScene& scene, const std::string& file,
              osg::GraphicsContext& context, const ProgressBar& progress)
{
    progress.show("drawing");
    CaptureOptions options = given;
    if (!options.isSizeGiven)
    {
        const glm::ivec2 size = ScenePicture::fitSize(given, scene);
        options.width = size.x;
        options.height = size.y;
    }
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
    ProgressBar progress;
    const std::unique_ptr<CaptureScene> scene = readScene(options, progress);
    LegoNode& lego = scene->getOnlyLegoNode();
    files.checkReplaceNoInput();
    checkLength(options, lego);
    progress.setRange(0.0, DESIGN_SHARE);
    const ModelDesign choice = design(options, lego, progress);
    const DesignCandidate& best = choice.getBest();
    lego.setSettings(best.settings);
    lego.setStoredBricks(best.model);
    checkInstructionsSize(options, lego);

    progress.setRange(DESIGN_SHARE, 1.0);
    writeInstructions(options, lego, {best.stability, best.plan}, context, progress);
    for (const char* ending : {".pdf", ".png", "-report.txt"}) // older ones would seem to belong to the new page
    {
        std::error_code ignored;
        std::filesystem::remove(files.get(ending), ignored);
    }
    if (options.base == BuildingBase::PLATE) scene->addBasePlate(*createBasePlate(*best.model));
    drawInto(options, *scene, files.get(".png"), context, progress);
    progress.show("printing the booklet");
    const std::string report = describeGoals(options, choice) + '\n' + choice.toString();
    const std::vector<std::string> defects = describeDefects(best, options);
    writeText(files.get("-report.txt"),
              [&](std::ostream& stream)
              {
                  if (!scene->getWarning().empty()) stream << "warning: " << scene->getWarning() << '\n';
                  for (const std::string& defect : defects)
                      stream << "warning: " << defect << '\n';
                  stream << report;
              });
    const std::string unprinted = printBooklet(files.get(".html"), files.get(".pdf"));
    progress.clear();

    fmt::print("{}\n", report);
    fmt::print("wrote '{}' and, with other endings, .html, .txt, {}.mpd, .csv, .xml and -report.txt\n",
               files.get(".png"), unprinted.empty() ? ".pdf, " : "");
    std::fflush(stdout); // before the warnings, where both are the same file
    if (!unprinted.empty()) printError("osglegocapture: warning: there is no PDF: {}\n", unprinted);
    for (const std::string& defect : defects)
        printError("osglegocapture: warning: {}\n", defect);
}

} // namespace osgLego
