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
// PartialStability::getNumHard() of a sequence, above which another attempt is given up. Sequences that help hardly
// have any such parts; others take minutes until parts fall.
constexpr std::size_t MOST_HARD = 1000;

/** The most parts of submodels in a sequence within which others are, or of parts that are joined in one hand. */
std::size_t getMostParts(std::size_t depth)
{
    return depth < BuildingPlan::DEEPEST_SUBMODEL ? BuildingUnits::MOST_PARTS : BuildingUnits::MOST_IN_HAND;
}

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

/** The number of submodels within boxes, of two parts and more, and of parts that are pressed on from below. */
std::size_t countSubmodels(const JointGraph& graph)
{
    BuildingUnits units(graph);
    const std::vector<bool> none(graph.getNumParts(), false);
    units.group(none, none);
    auto count = std::count_if(units.getUnits().begin(), units.getUnits().end(),
                               [](const BuildingUnits::Unit& unit) { return unit.parts.size() > 1; });
    for (std::uint32_t part = 0; part < graph.getNumParts(); ++part)
        count += units.isPressedOn(part) ? 1 : 0;
    return static_cast<std::size_t>(count);
}

} // namespace

PlanBuilder::PlanBuilder(const BrickModel& model, const PlanningOptions& options) :
    _model(model), _options(options), _boxes(createBuildingBoxes(model)), _turnedBoxes(turnUpsideDown(_boxes))
{
}

osg::ref_ptr<const BuildingPlan> PlanBuilder::build(std::size_t mostFalling)
{
    _mostFalling = mostFalling;
    const std::vector<PartList> pieces = findPieces();
    if (pieces.empty()) return BuildingPlan::create(0, {});
    std::vector<BuildingStep> steps = planSequence(pieces.front(), {0, false, false, _options.base});
    if (_isGivenUp) return nullptr;
    const std::size_t numHeldSteps = steps.size();
    std::size_t weight = 0; // of the last step
    for (const PartList& piece : std::span(pieces).subspan(1))
    {
        if (_isCancelled) return nullptr;
        const std::size_t added = piece.size() > 1 ? UnitQueue::getSubmodelWeight(piece.size()) : 1;
        if (steps.size() == numHeldSteps || weight + added > UnitQueue::USUAL)
        {
            steps.emplace_back();
            weight = 0;
        }
        addUnheld(piece, steps.back());
        weight += added;
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

/** The steps with the fewest after which parts fall: the other way up, if it is a submodel, and with submodels that
 * keep to the limits, even if no fewer fall. */
std::vector<BuildingStep> PlanBuilder::planSequence(const PartList& parts, const Setting& setting)
{
    Setting best = setting;
    Attempt chosen = attempt(parts, setting);
    const auto tryInstead = [&](const Setting& other, std::size_t mostFalls)
    {
        _isTryingAgain = true;
        _numFallsLeft = mostFalls;
        Attempt next = attempt(parts, other);
        _isTryingAgain = false;
        _numFallsLeft = ANY;
        if (std::exchange(_isGivenUp, false)) return;
        chosen = std::move(next);
        best = other;
    };
    Setting turned = setting;
    turned.isUpsideDown = !setting.isUpsideDown;
    if (setting.depth > 0 && chosen.numFalls > 0 && !_isTryingAgain) tryInstead(turned, chosen.numFalls - 1);
    if (!_isTryingAgain && chosen.largest > getMostParts(setting.depth))
    {
        Setting limited = best;
        limited.isLimited = true;
        tryInstead(limited, chosen.numFalls);
    }
    std::move(chosen.submodels.begin(), chosen.submodels.end(), std::back_inserter(_submodels));
    return std::move(chosen.steps);
}

PlanBuilder::Attempt PlanBuilder::attempt(const PartList& parts, const Setting& setting)
{
    const auto first = static_cast<std::ptrdiff_t>(_submodels.size());
    Attempt attempt;
    planSteps(parts, setting, attempt);
    attempt.submodels.assign(std::move_iterator(_submodels.begin() + first), std::move_iterator(_submodels.end()));
    _submodels.resize(static_cast<std::size_t>(first));
    const auto countFalls = [&attempt](const std::vector<BuildingStep>& steps)
    {
        attempt.numFalls += static_cast<std::size_t>(
            std::count_if(steps.begin(), steps.end(), [](const BuildingStep& step) { return !step.stands; }));
    };
    countFalls(attempt.steps);
    for (const Submodel& submodel : attempt.submodels)
        countFalls(submodel.steps);
    return attempt;
}

void PlanBuilder::planSteps(const PartList& parts, const Setting& setting, Attempt& attempt)
{
    const auto toParts = [&parts](const PartList& local)
    {
        PartList result;
        for (const std::uint32_t index : local)
            result.push_back(parts[index]);
        return result;
    };
    for (const AssemblyStep& assembly : assemble(parts, setting))
    {
        BuildingStep& step = attempt.steps.emplace_back();
        step.parts = toParts(assembly.parts);
        for (const PartList& submodel : assembly.submodels)
        {
            step.submodels.push_back(planSubmodel(toParts(submodel), setting));
            attempt.largest = std::max(attempt.largest, submodel.size());
        }
        step.stands = assembly.stands;
        step.isChecked = assembly.isChecked;
        step.isFromBelow = setting.isUpsideDown;
        step.turns = assembly.turns;
    }
}

/** The steps of parts, whose submodels are not planned yet. None if they were given up. */
std::vector<AssemblyStep> PlanBuilder::assemble(const PartList& parts, const Setting& setting)
{
    if (_isCancelled || _isGivenUp) return {};
    const std::size_t mostParts = setting.isLimited ? getMostParts(setting.depth) : parts.size();
    const auto [known, isNew] = _assemblies.try_emplace({parts, setting.isUpsideDown, mostParts});
    if (!isNew)
    {
        const std::vector<AssemblyStep>& steps = known->second;
        const bool isComplete =
            std::all_of(steps.begin(), steps.end(), [&](const AssemblyStep& step) { return proceed(0, step.stands); });
        return isComplete ? steps : std::vector<AssemblyStep>();
    }
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
        [&](std::size_t numPlaced, bool stands)
        {
            _isGivenUp = _isGivenUp || (_isTryingAgain && stability.getNumHard() > MOST_HARD);
            return proceed(setting.depth > 0 ? 0 : numPlaced, stands);
        },
        parts.size() <= MOST_VIEWED ? &views : nullptr, mostParts);
    std::vector<AssemblyStep> steps = builder.build();
    if (_isCancelled || _isGivenUp)
        _assemblies.erase(known);
    else
        known->second = steps;
    return steps;
}

/** The height of a cell, in studs. */
double PlanBuilder::getCellHeight() const
{
    const BrickGrid& grid = _model.getGrid();
    return grid.cellSize[grid.getUpIndex()] / grid.getPitch();
}

/** @param setting of the model or submodel that contains this one.
 * @return the index of the submodel. Those within it come before it. */
std::uint32_t PlanBuilder::planSubmodel(const PartList& parts, Setting setting)
{
    ++setting.depth;
    setting.base = BuildingBase::TABLE;
    setting.isUpsideDown = isBetterUpsideDown(parts);
    std::vector<BuildingStep> steps = planSequence(parts, setting);
    _submodels.push_back({std::move(steps)});
    return static_cast<std::uint32_t>(_submodels.size() - 1);
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
        step.submodels.push_back(planSubmodel(parts, {}));
    step.stands = false;
    step.isChecked = true;
    _unheld.insert(_unheld.end(), parts.begin(), parts.end());
}

/** @param numPlaced the parts of the model in place; those of submodels are counted when they are attached.
 * @param stands whether parts stand after the last step. */
bool PlanBuilder::proceed(std::size_t numPlaced, bool stands)
{
    _isCancelled = _isCancelled || (_options.isCancelled && _options.isCancelled());
    if (!stands && _numFallsLeft == 0) _isGivenUp = true;
    if (!stands && _numFallsLeft != ANY && !_isGivenUp) --_numFallsLeft;
    if (!stands && numPlaced > 0 && !_isTryingAgain && ++_numFalling > _mostFalling) _isGivenUp = true;
    if (_options.progress && numPlaced > 0)
    {
        const double share = static_cast<double>(numPlaced) / static_cast<double>(_boxes.size());
        _options.progress(0.5 * share + (_isTryingAgain ? 0.5 : 0.0));
    }
    return !_isCancelled && !_isGivenUp;
}

} // namespace osgLego
