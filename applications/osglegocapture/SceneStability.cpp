#include "SceneStability.h"

#include "Cancellation.h"
#include "ExitCode.h"

#include <common/ColorName.h>
#include <osgLego/Palette.h>
#include <osgLego/PartType.h>
#include <osgLego/PieceCount.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <osg/Timer>

namespace osgLego
{

namespace
{

constexpr std::size_t MOST_NAMED = 10; // parts that fall, in the text

std::string nameOf(const BrickModel& model, const Part& part)
{
    const PartType* type = findPartType(part, model.getGrid());
    return type ? type->getName() : "part";
}

std::string nameColorOf(const Part& part)
{
    if (part.colorCode == Part::NO_CODE)
        return fmt::format("colour #{:02x}{:02x}{:02x}", part.color[0], part.color[1], part.color[2]);
    const std::span<const PaletteColor> colors = Palette::getKnownColors();
    const auto known = std::find_if(colors.begin(), colors.end(),
                                    [&](const PaletteColor& color) { return color.code == part.colorCode; });
    return known == colors.end() ? fmt::format("colour {}", part.colorCode) : nameColor(*known);
}

std::string describe(const BrickModel& model, std::uint32_t index)
{
    if (index == StabilityReport::Joint::BASE) return "the base";
    const Part& part = model.getParts()[index];
    return fmt::format("{} in {} at {},{},{}", nameOf(model, part), nameColorOf(part), part.cell[0], part.cell[1],
                       part.cell[2]);
}

JsonValue toJson(const BrickModel& model, std::uint32_t index)
{
    if (index == StabilityReport::Joint::BASE) return "base";
    const Part& part = model.getParts()[index];
    JsonValue color;
    if (part.colorCode != Part::NO_CODE) color = part.colorCode;
    return {{"part", nameOf(model, part)},
            {"color", color},
            {"cell", JsonValue::createArray({part.cell[0], part.cell[1], part.cell[2]})}};
}

std::vector<AddedWeight> findWeights(const std::vector<osg::ref_ptr<const BrickModel>>& models,
                                     const std::vector<CaptureLoad>& loads)
{
    if (!loads.empty() && models.size() > 1)
        throw CaptureError(EXIT_BAD_INPUT,
                           fmt::format("there are {} nodes with parts; expected one with --load", models.size()));
    std::vector<AddedWeight> weights;
    for (const CaptureLoad& load : loads)
    {
        const BrickModel& model = *models.front();
        const Part* part = model.findPart(load.cell);
        if (!part)
            throw CaptureError(EXIT_BAD_INPUT,
                               fmt::format("--load: no part is in the cell {},{},{}; expected one that --cells lists",
                                           load.cell.x, load.cell.y, load.cell.z));
        weights.push_back({static_cast<std::uint32_t>(part - model.getParts().data()), load.grams});
    }
    return weights;
}

void warnOfTime(std::size_t numParts, const ProgressBar& progress)
{
    constexpr std::size_t NOTABLE = 10'000; // take more than ten seconds; 50,000, more than ten minutes
    if (numParts < NOTABLE) return;
    progress.warn(fmt::format("computing whether {} parts stand may take minutes; Ctrl+C cancels it", numParts));
}

/** Shows the seconds that the work has taken, by the thread that made it. Nothing tells how much is left. */
class StabilityProgress
{
public:
    StabilityProgress(std::size_t numParts, const ProgressBar& progress) : _numParts(numParts), _progress(progress) {}

    /** Call this regularly, from any thread. */
    void show()
    {
        if (std::this_thread::get_id() != _caller) return;
        const auto seconds = static_cast<int>(_timer.time_s());
        if (seconds == _seconds) return;
        _seconds = seconds;
        _progress.show(fmt::format("computing whether {} parts stand, {} s", _numParts, seconds));
    }

private:
    std::size_t _numParts;
    const ProgressBar& _progress;
    std::thread::id _caller = std::this_thread::get_id();
    osg::Timer _timer;
    int _seconds = 0;
};

} // namespace

SceneStability::SceneStability(const std::vector<osg::ref_ptr<const BrickModel>>& models, const CaptureOptions& options,
                               const ProgressBar& progress) :
    _base(options.base.value()),
    _weights(findWeights(models, options.loads))
{
    for (const osg::ref_ptr<const BrickModel>& model : models)
    {
        warnOfTime(model->getParts().size(), progress);
        StabilityProgress shown(model->getParts().size(), progress);
        const auto isCancelled = [&shown]
        {
            shown.show();
            return Cancellation::isRequested();
        };
        const std::optional<StabilityReport> report =
            computeStability(*model, {_base, isCancelled, _weights, options.tilt});
        Cancellation::check();
        _models.push_back({model, *report, countPieces(*model, _base)});
    }
}

const SceneStability::ModelStability& SceneStability::getWorst() const
{
    return *std::min_element(_models.begin(), _models.end(),
                             [](const ModelStability& a, const ModelStability& b)
                             { return a.report.margin < b.report.margin; });
}

std::optional<StabilityReport> SceneStability::getReport() const
{
    return _models.size() == 1 ? std::optional(_models.front().report) : std::nullopt;
}

std::string SceneStability::toText() const
{
    std::string text;
    for (const auto& [model, report, numPieces] : _models)
    {
        text += fmt::format("on a {}, {}\n", _base == BuildingBase::TABLE ? "table" : "base plate", report.toString());
        if (report.stands && numPieces > 1) text += fmt::format("  it is {} pieces that no part joins\n", numPieces);
        for (const AddedWeight& weight : _weights)
            text += fmt::format("  load: {:g} g on {}\n", weight.grams, describe(*model, weight.part));
        if (report.weakest)
            text += fmt::format("  weakest joint: {} on {}\n", describe(*model, report.weakest->upper),
                                describe(*model, report.weakest->lower));
        const std::vector<std::uint32_t> unheld = report.findUnheld();
        for (std::size_t index = 0; index < std::min(unheld.size(), MOST_NAMED); ++index)
            text += fmt::format("  not held: {}\n", describe(*model, unheld[index]));
        if (unheld.size() > MOST_NAMED) text += fmt::format("  and {} more\n", unheld.size() - MOST_NAMED);
    }
    return text;
}

JsonValue SceneStability::toJson() const
{
    const ModelStability& worst = getWorst();
    JsonValue weakest;
    if (worst.report.weakest)
        weakest = {{"lower", osgLego::toJson(*worst.model, worst.report.weakest->lower)},
                   {"upper", osgLego::toJson(*worst.model, worst.report.weakest->upper)}};
    JsonValue falling = JsonValue::createArray();
    JsonValue unknown = JsonValue::createArray();
    JsonValue loads = JsonValue::createArray();
    for (const AddedWeight& weight : _weights)
    {
        JsonValue load = osgLego::toJson(*worst.model, weight.part);
        load["grams"] = weight.grams;
        loads.append(load);
    }
    bool stands = true;
    bool safe = true;
    std::optional<double> tippingAngle;
    std::optional<std::array<double, 4>> tiltAngles;
    bool isTiltBound = false;
    std::size_t numPieces = 0;
    std::size_t numComponents = 0;
    double milliseconds = 0.0;
    for (const auto& [model, report, ownPieces] : _models)
    {
        for (const std::uint32_t part : report.falling)
            falling.append(osgLego::toJson(*model, part));
        for (const std::uint32_t part : report.unknown)
            unknown.append(osgLego::toJson(*model, part));
        stands = stands && report.stands;
        safe = safe && report.safe;
        if (report.tippingAngle)
            tippingAngle = std::min(tippingAngle.value_or(*report.tippingAngle), *report.tippingAngle);
        if (report.tiltAngles)
        {
            if (!tiltAngles) tiltAngles = report.tiltAngles;
            for (std::size_t side = 0; side < tiltAngles->size(); ++side)
                (*tiltAngles)[side] = std::min((*tiltAngles)[side], (*report.tiltAngles)[side]);
        }
        isTiltBound = isTiltBound || report.isTiltBound;
        numPieces += ownPieces;
        numComponents += report.numComponents;
        milliseconds += report.milliseconds;
    }
    return {{"base", _base == BuildingBase::TABLE ? "table" : "plate"},
            {"stands", stands},
            {"safe", safe},
            {"margin", worst.report.margin},
            {"marginIsBound", worst.report.isMarginBound},
            {"tippingAngle", tippingAngle ? JsonValue(*tippingAngle) : JsonValue()},
            {"tiltAngles", tiltAngles ? JsonValue::createArray(
                                            {(*tiltAngles)[0], (*tiltAngles)[1], (*tiltAngles)[2], (*tiltAngles)[3]})
                                      : JsonValue()},
            {"tiltIsBound", isTiltBound},
            {"falling", falling},
            {"unknown", unknown},
            {"weakest", weakest},
            {"loads", loads},
            {"pieces", numPieces},
            {"components", numComponents},
            {"milliseconds", std::round(1000.0 * milliseconds) / 1000.0}};
}

} // namespace osgLego
