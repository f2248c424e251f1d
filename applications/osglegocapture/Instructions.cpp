#include "Instructions.h"

#include "Cancellation.h"
#include "ExitCode.h"
#include "StandardError.h"

#include <common/NumberText.h>
#include <osgLego/BuildingPlanner.h>
#include <osgLegoBooklet/Booklet.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

std::string nameModel(const CaptureOptions& options)
{
    return options.mesh.empty() ? "the built-in model" : "'" + options.mesh + "'";
}

std::string findFile(const CaptureOptions& options)
{
    const std::string name = options.mesh.empty() ? "racing-car" : nameBooklet(options.mesh);
    return (std::filesystem::path(options.instructions) / (name + ".html")).string();
}

void throwIf(const std::optional<BookletError>& error)
{
    using Reason = BookletError::Reason;
    if (!error) return;
    if (error->reason == Reason::CANCELLED) Cancellation::check(error->message);
    switch (error->reason)
    {
    case Reason::BAD_VIEW:
    case Reason::BAD_STEPS:
        throw CaptureError(EXIT_BAD_OPTIONS, error->message);
    case Reason::NO_PLUGIN:
    case Reason::BAD_FILE:
        throw CaptureError(EXIT_BAD_OUTPUT, error->message);
    case Reason::NO_GL:
        throw CaptureError(EXIT_NO_GL, error->message);
    default:
        throw CaptureError(EXIT_BAD_INPUT, error->message);
    }
}

} // namespace

std::vector<std::string> getInstructionsFiles(const CaptureOptions& options)
{
    const std::string page = findFile(options);
    return {page, std::filesystem::path(page).replace_extension(".txt").string()};
}

void checkInstructionsPlace(const CaptureOptions& options)
{
    throwIf(checkBookletFile(findFile(options)));
}

void checkInstructionsSize(const CaptureOptions& options, const LegoNode& lego)
{
    const osg::ref_ptr<const BrickModel> model = lego.getBricks();
    const std::size_t numParts = model ? model->getParts().size() : 0;
    if (numParts <= CaptureOptions::MOST_PARTS_UNASKED || options.isBookletConfirmed || options.bookletSteps) return;
    PlanningOptions quick;
    quick.checksStability = false;
    quick.isCancelled = Cancellation::isRequested;
    const osg::ref_ptr<const BuildingPlan> plan = planBuilding(*model, quick);
    Cancellation::check("cancelled; the booklet was not written");
    throw CaptureError(EXIT_BAD_INPUT,
                       fmt::format("{} has {} parts in about {} steps; expected --yes to write all of them, or {}",
                                   nameModel(options), formatNumber(numParts), formatNumber(plan->getSteps().size()),
                                   options.build.empty() ? "--steps FIRST-LAST" : "a smaller model"));
}

BuildingView getInstructionsView(const CaptureOptions& options)
{
    return options.isViewGiven ? BuildingView{options.view.azimuth, options.view.elevation} : BuildingView();
}

void writeInstructions(const CaptureOptions& options, const LegoNode& lego, const KnownResults& known,
                       osg::GraphicsContext& context, const ProgressBar& progress)
{
    BookletOptions booklet;
    booklet.base = options.base.value_or(BuildingBase::TABLE);
    booklet.view = getInstructionsView(options);
    if (options.bookletSteps) booklet.steps = {options.bookletSteps->first, options.bookletSteps->second};
    booklet.stability = known.stability;
    booklet.plan = known.plan;
    booklet.title = options.title;
    booklet.author = options.author;
    booklet.license = options.license;
    booklet.modelName = nameModel(options);
    booklet.writesDownloads = !options.build.empty();
    booklet.isCancelled = Cancellation::isRequested;
    booklet.progress = [&progress](double share, const std::string& work) { progress.show(share, work); };
    const std::vector<std::string> files = getInstructionsFiles(options);
    throwIf(writeBooklet(lego, files.front(), context, booklet));
    progress.clear();
    if (!options.build.empty()) return;
    // The user has not typed the names. Standard output may be that of a list or of statistics.
    printError("osglegocapture: wrote '{}' and '{}'\n", files.front(), files.back());
}

} // namespace osgLego
