#include "Booklet.h"

#include "BookletModel.h"
#include "BookletPage.h"
#include "BookletPictures.h"
#include "BookletProgress.h"
#include "BookletRenderer.h"
#include "BookletText.h"
#include "Cancellation.h"

#include "../ExitCode.h"

#include <common/CompleteFile.h>
#include <osgLego/BuildingPlanner.h>
#include <osgLego/Palette.h>
#include <osgLego/Stability.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <osgDB/Registry>
#include <unistd.h>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MOST_PARTS_UNASKED = 2000;
/** Parts up to which the steps are planned with stability, which takes minutes for more. */
constexpr std::size_t MOST_CHECKED_PARTS = 2000;
/** Parts up to which it is computed whether the finished model stands. */
constexpr std::size_t MOST_COMPUTED_PARTS = 6000;
constexpr double PLANNING_SHARE = 0.1; // of the time, on the progress bar

std::string nameModel(const CaptureOptions& options)
{
    return options.mesh.empty() ? "the built-in model" : "'" + options.mesh + "'";
}

std::string nameFiles(const CaptureOptions& options)
{
    return options.mesh.empty() ? "racing-car" : nameBooklet(options.mesh);
}

CaptureError cannotWrite(const std::string& fileName, const std::string& why)
{
    return {EXIT_BAD_OUTPUT, "can't write '" + fileName + "': " + why};
}

/** The parts to build. */
osg::ref_ptr<const BrickModel> findModel(const CaptureOptions& options, const LegoNode& lego)
{
    osg::ref_ptr<const BrickModel> model = lego.getBricks();
    if (!model || model->getParts().empty())
        throw CaptureError(EXIT_BAD_INPUT,
                           nameModel(options) + " has no parts to build; expected parts=bricks among its settings");
    const BrickGrid& grid = model->getGrid();
    if (!std::all_of(model->getParts().begin(), model->getParts().end(),
                     [&grid](const Part& part) { return findPartType(part, grid) != nullptr; }))
        throw CaptureError(EXIT_BAD_INPUT,
                           nameModel(options) + " has parts of other shapes; expected bricks and plates of 1x1 to 2x8");
    return model;
}

osg::ref_ptr<const BuildingPlan> createPlan(const BrickModel& model, BuildingBase base, BookletProgress& progress)
{
    PlanningOptions options;
    options.base = base;
    options.checksStability = model.getParts().size() <= MOST_CHECKED_PARTS;
    options.isCancelled = Cancellation::isRequested;
    options.progress = [&progress](double share)
    { progress.show(PLANNING_SHARE * share, "planning the order of building"); };
    osg::ref_ptr<const BuildingPlan> plan = planBuilding(model, options);
    Cancellation::check();
    return plan;
}

/** Throws if the booklet would be very large, unless that is wanted. */
void checkSize(const CaptureOptions& options, const BrickModel& model)
{
    const std::size_t numParts = model.getParts().size();
    if (numParts <= MOST_PARTS_UNASKED || options.isBookletConfirmed || options.bookletSteps) return;
    PlanningOptions quick;
    quick.checksStability = false;
    quick.isCancelled = Cancellation::isRequested;
    const osg::ref_ptr<const BuildingPlan> plan = planBuilding(model, quick);
    Cancellation::check();
    throw CaptureError(
        EXIT_BAD_INPUT,
        fmt::format("{} has {} parts in about {} steps; expected --yes to write all of them, or --steps FIRST-LAST",
                    nameModel(options), formatNumber(numParts), formatNumber(plan->getSteps().size())));
}

/** A new folder for temporary files, which is removed with its files. */
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::error_code error;
        const fs::path place = fs::temp_directory_path(error);
        if (error)
            throw cannotWrite("osglegocapture-XXXXXX",
                              "there is no folder for temporary files; expected one in TMPDIR");
        std::string name = (place / "osglegocapture-XXXXXX").string();
        if (!mkdtemp(name.data())) throw cannotWrite(name, std::strerror(errno));
        _path = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder()
    {
        std::error_code ignored;
        fs::remove_all(_path, ignored);
    }

    const fs::path& getPath() const { return _path; }

private:
    fs::path _path;
};

/** The model in LDraw's format. Its writer needs the name of a file, which it writes into the text. */
std::string createMpd(const LegoNode& lego, const std::string& name)
{
    const TemporaryFolder folder;
    const fs::path file = folder.getPath() / (name + ".mpd");
    const osgDB::ReaderWriter::WriteResult result =
        osgDB::Registry::instance()->writeNode(lego, file.string(), nullptr);
    if (!result.success())
        throw CaptureError(EXIT_BAD_OUTPUT, result.message().empty() ? "there is no plugin osgdb_ldraw to write .mpd"
                                                                     : result.message());
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<BookletDownload> createDownloads(const std::string& name, const BookletModel& model, const LegoNode& lego)
{
    std::ostringstream wanted;
    model.getPartsList().writeWantedList(wanted);
    std::ostringstream table;
    model.getPartsList().writeCsv(table);
    return {{"Wanted list (BrickLink)", name + ".xml", "application/xml", wanted.str()},
            {"Parts list (CSV)", name + ".csv", "text/csv", table.str()},
            {"Model (LDraw)", name + ".mpd", "application/x-multi-part-ldraw", createMpd(lego, name)}};
}

/** @return nothing for models so large that it would take too long. */
std::optional<StabilityReport> computeStanding(const BrickModel& model, BuildingBase base)
{
    if (model.getParts().size() > MOST_COMPUTED_PARTS) return std::nullopt;
    const std::optional<StabilityReport> report = computeStability(model, {base, Cancellation::isRequested});
    Cancellation::check();
    return report;
}

/** Sentences for the cover if the model can't be built as planned. */
std::vector<std::string> createWarnings(const BookletModel& model, const std::optional<StabilityReport>& stability,
                                        const BuildingPlan& plan, BuildingBase base)
{
    std::vector<std::string> warnings;
    const std::string place = base == BuildingBase::TABLE ? "a table" : "a base plate";
    if (!stability)
        warnings.push_back("It was not computed whether this model stands, since it has so many parts.");
    else if (!stability->stands)
        warnings.push_back("This model does not stand on " + place + ": " + countOf(stability->falling.size(), "part") +
                           " would fall. Support it from below, or make it with support=on.");
    else if (!stability->safe)
        warnings.push_back("This model stands, but parts that are worn may not hold it: handle it with care.");
    if (const std::size_t unheld = model.getNumUnheld())
        warnings.push_back("This model can't be built as it is: nothing holds " + countOf(unheld, "part") + " when " +
                           (unheld == 1 ? "it is" : "they are") + " placed.");
    if (model.getNumPieces() > 1)
        warnings.push_back(
            fmt::format("This model consists of {} that no stud connects.", countOf(model.getNumPieces(), "piece")));
    if (const std::size_t numFalling = model.getNumFallingSteps())
        warnings.push_back(fmt::format("After {} the model, or a submodel, does not stand by itself: hold it there.",
                                       countOf(numFalling, "step")));
    if (const std::size_t numUnchecked = plan.getNumUnchecked())
        warnings.push_back(fmt::format("Of {}, it was not computed whether the model stands after {}.",
                                       countOf(numUnchecked, "step"), numUnchecked == 1 ? "it" : "them"));
    for (const std::string& warning :
         {model.getPartsList().describeNeverMade(), model.getPartsList().describeWithoutNumber()})
        if (!warning.empty()) warnings.push_back("Parts " + warning + ".");
    return warnings;
}

void setSteps(const CaptureOptions& options, std::size_t numSteps, BookletFacts& facts)
{
    facts.endStep = numSteps;
    if (!options.bookletSteps) return;
    const auto [first, last] = *options.bookletSteps;
    if (first > numSteps)
        throw CaptureError(EXIT_BAD_OPTIONS,
                           fmt::format("bad value '{}-{}' for --steps; expected FIRST-LAST from 1 to {}, the number of "
                                       "steps of {}",
                                       first, last, numSteps, nameModel(options)));
    facts.firstStep = first - 1;
    facts.endStep = std::min(last, numSteps);
}

/** Creates the folder of a booklet, and removes it if no booklet is written. */
class BookletFolder
{
public:
    explicit BookletFolder(const std::string& name) : _name(name)
    {
        std::error_code error;
        _isNew = fs::create_directory(_name, error);
        if (error) throw cannotWrite(name, error.message());
    }
    BookletFolder(const BookletFolder&) = delete;
    BookletFolder& operator=(const BookletFolder&) = delete;
    ~BookletFolder()
    {
        std::error_code ignored;
        if (_isNew) fs::remove(_name, ignored);
    }

    void keep() { _isNew = false; }

private:
    std::string _name;
    bool _isNew;
};

/** Write a file by a function that may throw. */
void writeFile(const std::string& fileName, const std::function<void(std::ostream&)>& write)
{
    std::exception_ptr failure; // a temporary file is removed only if its writer returns
    const auto writeTemporary = [&](const std::string& temporaryName) -> std::string
    {
        std::ofstream file(temporaryName, std::ios::binary);
        try
        {
            if (file) write(file);
        }
        catch (...)
        {
            failure = std::current_exception();
            return "cancelled";
        }
        file.close();
        return file ? std::string() : std::string(std::strerror(errno));
    };
    const std::string why = writeCompleteFile(fileName, writeTemporary);
    if (failure) std::rethrow_exception(failure);
    if (!why.empty()) throw cannotWrite(fileName, why);
}

} // namespace

std::string getBookletFile(const CaptureOptions& options)
{
    return (fs::path(options.instructions) / (nameFiles(options) + ".html")).string();
}

void checkBookletPlace(const CaptureOptions& options)
{
    std::error_code ignored;
    fs::path folder = fs::path(options.instructions);
    if (!folder.has_filename()) folder = folder.parent_path(); // without the slash at the end
    // A folder that does not exist yet is created by the rules for a file in its place.
    const std::string file = fs::exists(folder, ignored) ? getBookletFile(options) : folder.string();
    if (const std::string obstacle = findObstacleToWriting(file); !obstacle.empty())
        throw cannotWrite(getBookletFile(options), obstacle);
}

void writeBooklet(const CaptureOptions& options, LegoNode& lego,
                  const std::function<osg::ref_ptr<osg::GraphicsContext>()>& createContext)
{
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read(lego.getSettings(), error);
    if (!error.empty()) throw CaptureError(EXIT_BAD_INPUT, error);
    const osg::ref_ptr<const BrickModel> bricks = findModel(options, lego);
    const Cancellation cancellation; // from here on, all long work asks it
    checkSize(options, *bricks);
    // Before planning, which may take long.
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    BookletRenderer renderer(*context);

    BookletProgress progress;
    const BuildingBase base = options.base.value_or(BuildingBase::TABLE);
    const osg::ref_ptr<const BuildingPlan> plan = createPlan(*bricks, base, progress);
    lego.setBuildingPlan(plan); // for the steps in its .mpd
    const BookletModel model(*bricks, *plan, palette ? palette->getColors() : std::span<const PaletteColor>());

    BookletFacts facts;
    facts.title = titleOf(nameFiles(options));
    facts.warnings = createWarnings(model, computeStanding(*bricks, base), *plan, base);
    facts.downloads = createDownloads(nameFiles(options), model, lego);
    Cancellation::check();
    setSteps(options, model.getMainChapter().steps.size(), facts);

    BookletPictures pictures(model, renderer);
    std::size_t numDone = 0;
    std::size_t numPictures = 0;
    BookletPage page(model, facts, pictures,
                     [&](const std::string& work)
                     {
                         Cancellation::check();
                         const double share = static_cast<double>(numDone++) / static_cast<double>(numPictures);
                         progress.show(PLANNING_SHARE + (1.0 - PLANNING_SHARE) * share, work);
                     });
    numPictures = page.countPictures();
    BookletFolder folder(options.instructions);
    writeFile(getBookletFile(options), [&page](std::ostream& stream) { page.write(stream); });
    folder.keep();
}

} // namespace osgLego
