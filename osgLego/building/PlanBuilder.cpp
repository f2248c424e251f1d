#include <osgLego/building/PlanBuilder.h>

#include <osgLego/building/StepBuilder.h>
#include <osgLego/building/StepViews.h>
#include <osgLego/stability/PartialStability.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <utility>

namespace osgLego
{

namespace
{

// Larger models are shown from one direction: the search for hidden parts would take longer than planning.
constexpr std::size_t MOST_VIEWED = 20'000;

/** The area on which boxes stand, in studs. */
int measureBase(const JointGraph& graph)
{
    int area = 0;
    for (std::uint32_t part = 0; part < graph.getNumParts(); ++part)
    {
        const glm::ivec3 size = graph.getBox(part).upper - graph.getBox(part).lower;
        if (graph.isOnBase(part)) area += size.x * size.y;
    }
    return area;
}

/** The number of submodels within boxes. */
std::size_t countSubmodels(const JointGraph& graph)
{
    BuildingUnits units(graph);
    const std::vector<bool> none(graph.getNumParts(), false);
    units.group(none, none);
    return static_cast<std::size_t>(std::count_if(units.getUnits().begin(), units.getUnits().end(),
                                                  [](const BuildingUnits::Unit& unit)
                                                  { return unit.parts.size() > 1; }));
}

} // namespace

PlanBuilder::PlanBuilder(const BrickModel& model, const PlanningOptions& options) :
    _model(model), _options(options), _boxes(createBuildingBoxes(model)), _turnedBoxes(turnUpsideDown(_boxes))
{
}

osg::ref_ptr<const BuildingPlan> PlanBuilder::build()
{
    const std::vector<PartList> pieces = findPieces();
    if (pieces.empty()) return BuildingPlan::create(0, {});
    std::vector<BuildingStep> steps = planSteps(pieces.front(), {false, false, _options.base});
    const std::size_t numHeldSteps = steps.size();
    for (const PartList& piece : std::span(pieces).subspan(1))
    {
        if (_isCancelled) return nullptr;
        const bool isFull =
            !steps.empty() &&
            steps.back().parts.size() + UnitQueue::SUBMODEL_WEIGHT * steps.back().submodels.size() >= UnitQueue::USUAL;
        if (steps.size() == numHeldSteps || isFull) steps.emplace_back();
        addUnheld(piece, steps.back());
    }
    if (_isCancelled) return nullptr;
    // No step of one part at the end: unheld pieces have no order.
    if (steps.size() > numHeldSteps + 1 && steps.back().parts.size() == 1 && steps.back().submodels.empty() &&
        steps[steps.size() - 2].parts.size() > 2)
    {
        std::vector<std::uint32_t>& before = steps[steps.size() - 2].parts;
        steps.back().parts.push_back(before.back());
        before.pop_back();
    }
    if (_options.progress) _options.progress(1.0);
    std::sort(_unheld.begin(), _unheld.end());
    return BuildingPlan::create(_boxes.size(), std::move(steps), std::move(_submodels), std::move(_unheld));
}

/** The parts that joints connect to the base, and then each connected group of others. */
std::vector<PlanBuilder::PartList> PlanBuilder::findPieces() const
{
    const JointGraph graph(_boxes);
    UnionFind sets;
    sets.reset(_boxes.size() + 1); // the first one stands for the base
    for (std::uint32_t part = 0; part < _boxes.size(); ++part)
    {
        if (graph.isOnBase(part)) sets.join(0, static_cast<std::int32_t>(part + 1));
        for (const PartLink& joint : graph.getJointsAbove(part))
            sets.join(static_cast<std::int32_t>(part + 1), static_cast<std::int32_t>(joint.part + 1));
    }
    std::map<std::int32_t, PartList> pieces;
    for (std::uint32_t part = 0; part < _boxes.size(); ++part)
        pieces[sets.find(static_cast<std::int32_t>(part + 1))].push_back(part);
    std::vector<PartList> lists;
    lists.reserve(pieces.size());
    for (auto& [set, parts] : pieces)
        lists.push_back(std::move(parts));
    return lists;
}

std::vector<BuildingBox> PlanBuilder::select(const PartList& parts, bool isUpsideDown) const
{
    std::vector<BuildingBox> boxes;
    boxes.reserve(parts.size());
    for (const std::uint32_t part : parts)
        boxes.push_back((isUpsideDown ? _turnedBoxes : _boxes)[part]);
    return boxes;
}

std::vector<BuildingStep> PlanBuilder::planSteps(const PartList& parts, const Setting& setting)
{
    const JointGraph graph(select(parts, setting.isUpsideDown));
    PartialStability stability(
        _model, parts, graph,
        {.isUpsideDown = setting.isUpsideDown, .base = setting.base, .isCancelled = _options.isCancelled});
    StepBuilder::FindFalling findFalling;
    if (_options.checksStability)
        findFalling = [&stability](const std::vector<bool>& isPlaced) { return stability.findFalling(isPlaced); };
    StepViews views(graph.getBoxes(), getCellHeight(), _options.view, !setting.isUpsideDown);
    StepBuilder builder(
        graph, findFalling,
        [this, &setting](std::size_t numPlaced) { return proceed(setting.isSubmodel ? 0 : numPlaced); },
        parts.size() <= MOST_VIEWED ? &views : nullptr);
    const auto toParts = [&parts](const PartList& local)
    {
        PartList result;
        for (const std::uint32_t index : local)
            result.push_back(parts[index]);
        return result;
    };
    std::vector<BuildingStep> steps;
    for (const AssemblyStep& assembly : builder.build())
    {
        BuildingStep& step = steps.emplace_back();
        step.parts = toParts(assembly.parts);
        for (const PartList& submodel : assembly.submodels)
            step.submodels.push_back(planSubmodel(toParts(submodel)));
        step.stands = assembly.stands;
        step.isChecked = assembly.isChecked;
        step.isFromBelow = setting.isUpsideDown;
        step.turns = assembly.turns;
    }
    return steps;
}

/** The height of a cell, in studs. */
double PlanBuilder::getCellHeight() const
{
    const BrickGrid& grid = _model.getGrid();
    return grid.cellSize[grid.getUpIndex()] / grid.getPitch();
}

/** @return the index of the submodel. Those within it come before it. */
std::uint32_t PlanBuilder::planSubmodel(const PartList& parts)
{
    const auto numBefore = static_cast<std::ptrdiff_t>(_submodels.size());
    const bool isUpsideDown = isBetterUpsideDown(parts);
    std::vector<BuildingStep> steps = planSteps(parts, {true, isUpsideDown, BuildingBase::TABLE});
    if (const std::size_t numFalls = countFalls(steps, numBefore); numFalls > 0 && !_isTryingAgain)
    {
        _isTryingAgain = true;
        std::vector<Submodel> inner(_submodels.begin() + numBefore, _submodels.end());
        _submodels.resize(static_cast<std::size_t>(numBefore));
        std::vector<BuildingStep> turned = planSteps(parts, {true, !isUpsideDown, BuildingBase::TABLE});
        if (countFalls(turned, numBefore) < numFalls)
            steps = std::move(turned);
        else
        {
            _submodels.resize(static_cast<std::size_t>(numBefore));
            std::move(inner.begin(), inner.end(), std::back_inserter(_submodels));
        }
        _isTryingAgain = false;
    }
    _submodels.push_back({std::move(steps)});
    return static_cast<std::uint32_t>(_submodels.size() - 1);
}

/** The number of steps after which parts fall, also of submodels from an index on. */
std::size_t PlanBuilder::countFalls(const std::vector<BuildingStep>& steps, std::ptrdiff_t firstSubmodel) const
{
    const auto falls = [](const BuildingStep& step) { return !step.stands; };
    auto count = std::count_if(steps.begin(), steps.end(), falls);
    for (auto submodel = _submodels.begin() + firstSubmodel; submodel != _submodels.end(); ++submodel)
        count += std::count_if(submodel->steps.begin(), submodel->steps.end(), falls);
    return static_cast<std::size_t>(count);
}

/** Whether fewer submodels are needed upside down, or parts stand on a far larger base. */
bool PlanBuilder::isBetterUpsideDown(const PartList& parts) const
{
    constexpr int FAR_LARGER = 2;
    const JointGraph upright(select(parts, false));
    const JointGraph turned(select(parts, true));
    const std::size_t numUpright = countSubmodels(upright);
    const std::size_t numTurned = countSubmodels(turned);
    if (numUpright != numTurned) return numTurned < numUpright;
    return measureBase(turned) > FAR_LARGER * measureBase(upright);
}

/** Add the parts that can't be placed. */
void PlanBuilder::addUnheld(const PartList& parts, BuildingStep& step)
{
    if (parts.size() == 1)
        step.parts.push_back(parts.front());
    else
        step.submodels.push_back(planSubmodel(parts));
    step.stands = false;
    step.isChecked = true;
    _unheld.insert(_unheld.end(), parts.begin(), parts.end());
}

/** @param numPlaced the parts of the model in place; those of submodels are counted when they are attached. */
bool PlanBuilder::proceed(std::size_t numPlaced)
{
    _isCancelled = _isCancelled || (_options.isCancelled && _options.isCancelled());
    if (_options.progress && numPlaced > 0)
        _options.progress(static_cast<double>(numPlaced) / static_cast<double>(_boxes.size()));
    return !_isCancelled;
}

} // namespace osgLego
