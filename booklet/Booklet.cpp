#include <osgLegoBooklet/Booklet.h>

#include "BookletCover.h"
#include "BookletDownloads.h"
#include "BookletFailure.h"
#include "BookletFile.h"
#include "BookletModel.h"
#include "BookletPage.h"
#include "BookletPictures.h"
#include "BookletRenderer.h"
#include "BookletWords.h"

#include <common/BasePlate.h>
#include <common/LegolizeName.h>
#include <common/ModelHeader.h>
#include <common/PictureRenderer.h>
#include <common/ReadableName.h>
#include <osgLego/BuildingPlanner.h>
#include <osgLego/Palette.h>

#include <algorithm>
#include <span>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>

namespace osgLego
{

namespace
{

using Reason = BookletError::Reason;

/** Parts up to which the steps are planned with stability, which takes minutes for more. */
constexpr std::size_t MOST_CHECKED_PARTS = 5000;
/** Parts up to which it is computed whether the finished model stands. */
constexpr std::size_t MOST_COMPUTED_PARTS = 6000;
constexpr double PLANNING_SHARE = 0.1; // of the time

/** The file for the instructions in words, beside the page. */
std::string nameText(const std::string& fileName)
{
    return osgDB::getNameLessExtension(fileName) + ".txt";
}

/** Makes one booklet. Throws BookletFailure. */
class BookletWriter
{
public:
    BookletWriter(const LegoNode& lego, const BookletOptions& options) : _lego(lego), _options(options) {}

    void write(const std::string& fileName, osg::GraphicsContext& context) const;

private:
    void checkView() const;
    void checkCancellation() const;
    void report(double share, const std::string& work) const;
    osg::ref_ptr<const BrickModel> findModel() const;
    osg::ref_ptr<const BuildingPlan> createPlan(const BrickModel& model) const;
    std::optional<StabilityReport> findStability(const BrickModel& model) const;
    void setSteps(std::size_t numSteps, BookletFacts& facts) const;
    void writePage(const std::string& fileName, const BookletModel& model, const BookletFacts& facts,
                   BookletPictureSource& pictures) const;
    void writeDownloads(const std::string& fileName, const std::vector<BookletDownload>& downloads) const;

    const LegoNode& _lego;
    const BookletOptions& _options;
};

void BookletWriter::checkView() const
{
    const BuildingView& view = _options.view;
    if (view.isValid()) return;
    throw BookletFailure(
        Reason::BAD_VIEW,
        fmt::format(
            "a booklet can't be seen from {},{}; expected an azimuth in degrees, and {} to {} degrees of elevation",
            view.azimuth, view.elevation, BuildingView::LEAST_ELEVATION, BuildingView::MOST_ELEVATION));
}

void BookletWriter::checkCancellation() const
{
    if (_options.isCancelled && _options.isCancelled())
        throw BookletFailure(Reason::CANCELLED, "cancelled; the booklet was not written");
}

void BookletWriter::report(double share, const std::string& work) const
{
    if (_options.progress) _options.progress(share, work);
}

/** The parts to build. */
osg::ref_ptr<const BrickModel> BookletWriter::findModel() const
{
    // The settings tell it before the bricks are made, which may take long.
    const bool mayHaveParts = _lego.getStoredBricks() || _lego.getSettings().parts.set != PartSet::NONE;
    const osg::ref_ptr<const BrickModel> model = mayHaveParts ? _lego.getBricks() : nullptr;
    if (const std::string obstacle = mayHaveParts && !model ? _lego.getObstacle() : std::string(); !obstacle.empty())
        throw BookletFailure(Reason::BAD_MODEL, _options.modelName + " has no bricks: " + obstacle);
    if (!model || model->getParts().empty())
        throw BookletFailure(Reason::BAD_MODEL, _options.modelName + " has no parts to build; expected parts=bricks "
                                                                     "among its settings");
    const BrickGrid& grid = model->getGrid();
    if (!std::all_of(model->getParts().begin(), model->getParts().end(),
                     [&grid](const Part& part) { return findPartType(part, grid) != nullptr; }))
        throw BookletFailure(Reason::BAD_MODEL, _options.modelName + " has parts of other shapes; expected bricks and "
                                                                     "plates of 1x1 to 2x8");
    return model;
}

osg::ref_ptr<const BuildingPlan> BookletWriter::createPlan(const BrickModel& model) const
{
    if (_options.plan && _options.plan->getRanks().size() == model.getParts().size()) return _options.plan;
    PlanningOptions planning;
    planning.base = _options.base;
    planning.view = _options.view;
    planning.checksStability = model.getParts().size() <= MOST_CHECKED_PARTS;
    planning.isCancelled = _options.isCancelled;
    planning.progress = [this](double share) { report(PLANNING_SHARE * share, "planning the order of building"); };
    osg::ref_ptr<const BuildingPlan> plan = planBuilding(model, planning);
    checkCancellation();
    return plan;
}

/** @return nothing for models so large that it would take too long. */
std::optional<StabilityReport> BookletWriter::findStability(const BrickModel& model) const
{
    if (_options.stability) return _options.stability;
    if (model.getParts().size() > MOST_COMPUTED_PARTS) return std::nullopt;
    std::optional<StabilityReport> report = computeStability(model, {_options.base, _options.isCancelled});
    checkCancellation();
    return report;
}

void BookletWriter::setSteps(std::size_t numSteps, BookletFacts& facts) const
{
    facts.endStep = numSteps;
    if (!_options.steps) return;
    const auto [first, last] = *_options.steps;
    if (first > numSteps)
        throw BookletFailure(Reason::BAD_STEPS,
                             fmt::format("{} has no steps {}-{}; expected FIRST-LAST from 1 to {}, the number of steps",
                                         _options.modelName, first, last, numSteps));
    facts.firstStep = first - 1;
    facts.endStep = std::min(last, numSteps);
}

void BookletWriter::writePage(const std::string& fileName, const BookletModel& model, const BookletFacts& facts,
                              BookletPictureSource& pictures) const
{
    std::size_t numDone = 0;
    std::size_t numPictures = 0;
    BookletPage page(model, facts, pictures,
                     [&](const std::string& work)
                     {
                         checkCancellation();
                         const double share = static_cast<double>(numDone++) / static_cast<double>(numPictures);
                         report(PLANNING_SHARE + (1.0 - PLANNING_SHARE) * share, work);
                     });
    numPictures = page.countPictures();
    BookletFolder folder(fileName);
    writeBookletFile(fileName, [&page](std::ostream& stream) { page.write(stream); });
    folder.keep();
}

void BookletWriter::write(const std::string& fileName, osg::GraphicsContext& context) const
{
    if (_options.steps && (_options.steps->first < 1 || _options.steps->first > _options.steps->last))
        throw BookletFailure(Reason::BAD_STEPS,
                             fmt::format("{} has no steps {}-{}; expected FIRST-LAST, counted from 1",
                                         _options.modelName, _options.steps->first, _options.steps->last));
    checkView();
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read(_lego.getSettings(), error);
    // Stored bricks don't need the file of their palette: LDraw's codes name their colours.
    if (!error.empty() && !_lego.getStoredBricks()) throw BookletFailure(Reason::BAD_MODEL, error);
    const std::span<const PaletteColor> colors = palette         ? palette->getColors()
                                                 : error.empty() ? std::span<const PaletteColor>()
                                                                 : Palette::getKnownColors();
    const osg::ref_ptr<const BrickModel> bricks = findModel();
    // Before planning, which may take long.
    const std::string missing = PictureRenderer::findMissing(context);
    if (!missing.empty()) throw BookletFailure(Reason::NO_GL, missing);
    BookletRenderer renderer(context);

    const osg::ref_ptr<const BuildingPlan> plan = createPlan(*bricks);
    const BookletModel model(*bricks, *plan, colors, _options.base);
    BookletFacts facts;
    setSteps(model.getMainChapter().steps.size(), facts);
    const osg::ref_ptr<LegoNode> planned = new LegoNode;
    planned->setName(_lego.getName());
    planned->setStoredBricks(bricks);
    planned->setSettings(_lego.getSettings());
    planned->setBuildingPlan(plan);

    const std::string name = osgDB::getStrippedName(fileName);
    ModelHeader header{_options.title, _options.author, _options.license};
    header.complete(ModelHeader::find(_lego));
    header.complete({toReadableName(fileName), {}, {}});
    facts.title = header.title;
    facts.author = header.author;
    facts.warnings = createWarnings(model, findStability(*bricks), *plan, _options.base);
    std::ostringstream words;
    BookletWords writer(model, _options.view);
    writer.setSteps(facts.firstStep, facts.endStep);
    writer.write(words, facts.title);
    facts.downloads = createDownloads(name, model, *planned, header);
    checkCancellation();
    BookletPictures pictures(model, renderer, _options.view);
    facts.downloads.push_back({"Instructions in words", name + ".txt", "text/plain;charset=utf-8", words.str()});
    writePage(fileName, model, facts, pictures);
    writeDownloads(fileName, facts.downloads);
}

void BookletWriter::writeDownloads(const std::string& fileName, const std::vector<BookletDownload>& downloads) const
{
    const std::string words = osgDB::getSimpleFileName(nameText(fileName));
    for (const BookletDownload& download : downloads)
        if (_options.writesDownloads || download.fileName == words)
            writeBookletFile(osgDB::concatPaths(osgDB::getFilePath(fileName), download.fileName),
                             [&](std::ostream& stream) { stream << download.content; });
}

void checkFile(const std::string& fileName)
{
    checkBookletFiles({fileName, nameText(fileName)});
    findLDrawWriter();
}

} // namespace

std::optional<BookletError> checkBookletFile(const std::string& fileName)
try
{
    checkFile(fileName);
    return std::nullopt;
}
catch (const BookletFailure& failure)
{
    return failure.getError();
}

std::optional<BookletError> writeBooklet(const LegoNode& lego, const std::string& fileName,
                                         osg::GraphicsContext& context, const BookletOptions& options)
try
{
    checkFile(fileName);
    BookletWriter(lego, options).write(fileName, context);
    return std::nullopt;
}
catch (const BookletFailure& failure)
{
    return failure.getError();
}

std::string nameBooklet(const std::string& modelFileName)
{
    const std::string name = osgDB::getStrippedName(LegolizeName::stripPseudoLoaders(modelFileName));
    return name.empty() ? "model" : name;
}

osg::ref_ptr<const BrickModel> createBasePlate(const BrickModel& model)
{
    return BasePlate(model).createModel(false);
}

} // namespace osgLego
