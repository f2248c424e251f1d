#include <osgLego/building/StepBuilder.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

StepBuilder::StepBuilder(const JointGraph& graph, FindFalling findFalling, Proceed proceed, StepViews* views,
                         std::size_t mostParts) :
    _graph(graph),
    _symmetry(graph.getBoxes()), _order(graph, _symmetry), _findFalling(std::move(findFalling)),
    _proceed(std::move(proceed)), _views(views), _units(graph, mostParts),
    _hasSubmodels(mostParts > BuildingUnits::MOST_IN_HAND), _isPlaced(graph.getNumParts(), false),
    _isHung(graph.getNumParts(), false), _isLost(graph.getNumParts(), false), _isDeferred(graph.getNumParts(), false)
{
}

std::vector<AssemblyStep> StepBuilder::build()
{
    regroup();
    while (!_queue->isEmpty())
    {
        const std::size_t numSteps = _steps.size();
        const UnitList units = proposeStep();
        const std::vector<std::uint32_t> falling = findFalling(units);
        if (falling.empty())
            place(units, true);
        else if (isLost(falling) || !(repair(units, falling) || defer(units, falling)))
        {
            for (const std::uint32_t part : falling)
                _isLost[part] = true;
            place(units, false);
        }
        if (!_proceed(_numPlaced, _steps.size() == numSteps || _steps.back().stands)) return {};
    }
    fillLastStep();
    return std::move(_steps);
}

/** If the last step has only one part, place it in the step before, or the last part of that step with it. */
void StepBuilder::fillLastStep()
{
    if (_steps.size() < 2) return;
    AssemblyStep& before = _steps[_steps.size() - 2];
    AssemblyStep& last = _steps.back();
    if (!last.submodels.empty() || last.parts.size() != 1 || before.parts.empty()) return;
    std::vector<std::uint32_t> all = before.parts;
    all.push_back(last.parts.front());
    if (before.submodels.empty() && all.size() <= UnitQueue::USUAL_MOST && (!_views || _views->canShow(all, false)))
    {
        last.parts = all;
        _steps.erase(_steps.end() - 2);
        return;
    }
    const std::vector<std::uint32_t> parts(all.end() - 2, all.end());
    const auto joints = _graph.getJointsAbove(parts.front());
    const bool isInHand =
        std::any_of(joints.begin(), joints.end(),
                    [&before](const PartLink& joint)
                    { return std::find(before.parts.begin(), before.parts.end(), joint.part) != before.parts.end(); });
    if (isInHand) return; // with the part from which it hangs
    std::size_t weight = before.parts.size();
    for (const std::vector<std::uint32_t>& submodel : before.submodels)
        weight += UnitQueue::getSubmodelWeight(submodel.size());
    if (weight <= UnitQueue::LEAST || !before.stands || isBelow(parts.front(), before.submodels) ||
        (_views && !_views->canShow(parts, false)))
        return;
    if (_findFalling)
    {
        std::vector<bool> isPlaced = _isPlaced;
        for (const std::uint32_t part : parts)
            isPlaced[part] = false;
        const std::optional<std::vector<std::uint32_t>> falling = _findFalling(isPlaced);
        if (!falling || !falling->empty()) return;
        before.isChecked = true;
    }
    before.parts.pop_back();
    last.parts = parts;
}

/** Whether a part of a submodel is above a part. */
bool StepBuilder::isBelow(std::uint32_t part, const std::vector<std::vector<std::uint32_t>>& submodels) const
{
    const auto next = _graph.getNextAbove(part);
    return std::any_of(next.begin(), next.end(),
                       [&submodels](const PartLink& link)
                       {
                           return std::any_of(
                               submodels.begin(), submodels.end(),
                               [&link](const std::vector<std::uint32_t>& parts)
                               { return std::find(parts.begin(), parts.end(), link.part) != parts.end(); });
                       });
}

void StepBuilder::regroup()
{
    _units.group(_isPlaced, _isHung);
    _queue = std::make_unique<UnitQueue>(_units, _order, _symmetry);
    _isDelayed.assign(_units.getUnits().size(), false);
}

/** The next step. It contains units that fell before only if no other unit can be placed. */
UnitList StepBuilder::proposeStep()
{
    UnitList units = propose();
    if (_queue->getWeight(units) < UnitQueue::LEAST)
    {
        _isDelayed.assign(_isDelayed.size(), false);
        units = propose();
    }
    if (units.empty()) units = _queue->propose(_isDelayed);
    shorten(units);
    return units;
}

/** The units to be placed next, without delayed ones and those with deferred parts. None if no others can be placed. */
UnitList StepBuilder::propose()
{
    std::vector<bool> isAvoided = _isDelayed;
    for (std::uint32_t part = 0; part < _graph.getNumParts(); ++part)
        if (_isDeferred[part] && !_isPlaced[part]) isAvoided[_units.getUnitOf(part)] = true;
    return _queue->propose(isAvoided);
}

/** Whether no part of a step is hidden; parts of submodels may be, since they have steps of their own. */
bool StepBuilder::canShow(const UnitList& units, bool isTurning) const
{
    if (!_views) return true;
    std::vector<std::uint32_t> parts;
    for (const std::uint32_t unit : units)
        if (const std::vector<std::uint32_t>& own = _units.getUnits()[unit].parts; !_queue->isSubmodel(unit))
            parts.insert(parts.end(), own.begin(), own.end());
    return _views->canShow(parts, isTurning);
}

/** Leave out the last units if some part is hidden otherwise, and if enough remain; preferably without a turn. If too
 * few remain, leave out those that hide others. */
void StepBuilder::shorten(UnitList& units) const
{
    for (const bool isTurning : {false, true})
        for (UnitList shorter = units; _queue->getWeight(shorter) >= UnitQueue::LEAST; shorter.pop_back())
        {
            if (leavesOne(shorter, units) || !canShow(shorter, isTurning)) continue;
            units = shorter;
            return;
        }
    for (const bool isTurning : {false, true})
    {
        UnitList visible;
        for (const std::uint32_t unit : units)
            if (UnitList longer = visible; _queue->addWithAllBefore(unit, longer) &&
                                           longer.size() == visible.size() + 1 && canShow(longer, isTurning))
                visible = longer;
        if (_queue->getWeight(visible) < UnitQueue::LEAST || leavesOne(visible, units)) continue;
        units = visible;
        return;
    }
}

/** Whether a single unit remains for the last step if some units of a step are left out. */
bool StepBuilder::leavesOne(const UnitList& shorter, const UnitList& units) const
{
    return shorter.size() < units.size() && _queue->getNumOpen() == shorter.size() + 1;
}

void StepBuilder::mark(const UnitList& units, bool isPlaced)
{
    for (const std::uint32_t unit : units)
        for (const std::uint32_t part : _units.getUnits()[unit].parts)
            _isPlaced[part] = isPlaced;
}

void StepBuilder::place(const UnitList& units, bool stands)
{
    AssemblyStep step;
    step.stands = stands;
    step.isChecked = !stands || _isKnown;
    std::vector<std::uint32_t> shown;
    const bool isHiding =
        std::any_of(units.begin(), units.end(), [&](std::uint32_t unit) { return canBeSubmodel(unit, units); }) &&
        !canShow(units, true);
    for (const std::uint32_t unit : units)
    {
        const std::vector<std::uint32_t>& parts = _units.getUnits()[unit].parts;
        _numPlaced += parts.size();
        shown.insert(shown.end(), parts.begin(), parts.end());
        if (_queue->isSubmodel(unit) || (isHiding && canBeSubmodel(unit, units)))
            step.submodels.push_back(parts);
        else
            step.parts.insert(step.parts.end(), parts.begin(), parts.end());
    }
    if (_views) step.turns = _views->show(shown);
    _steps.push_back(std::move(step));
    mark(units, true);
    _queue->take(units);
}

/** Whether parts that are joined in a hand may be shown as a submodel: none of a step are placed after them. */
bool StepBuilder::canBeSubmodel(std::uint32_t unit, const UnitList& units) const
{
    const BuildingUnits::Unit& own = _units.getUnits()[unit];
    if (!_hasSubmodels || own.parts.size() == 1) return false;
    return std::none_of(units.begin(), units.end(),
                        [&own](std::uint32_t other)
                        { return std::binary_search(own.next.begin(), own.next.end(), other); });
}

/** The parts that fall if units are added; none if that is not known. */
std::vector<std::uint32_t> StepBuilder::findFalling(const UnitList& units)
{
    if (!_findFalling) return {};
    mark(units, true);
    const std::optional<std::vector<std::uint32_t>> falling = _findFalling(_isPlaced);
    mark(units, false);
    _isKnown = falling.has_value();
    return falling.value_or(std::vector<std::uint32_t>());
}

/** Whether parts have fallen before. All parts above them fall, too. */
bool StepBuilder::isLost(const std::vector<std::uint32_t>& falling) const
{
    return std::any_of(falling.begin(), falling.end(), [this](std::uint32_t part) { return _isLost[part]; });
}

/** Repair a step with units after which parts fall: place other units, or group the parts in another way.
 * @return whether the situation has changed. */
bool StepBuilder::repair(const UnitList& units, const std::vector<std::uint32_t>& falling)
{
    return clamp(units, falling) || postpone(units, falling) || hang(units, falling);
}

/** Place the falling parts in one step with parts above that hold them, if these stand. */
bool StepBuilder::clamp(const UnitList& units, const std::vector<std::uint32_t>& falling)
{
    UnitList step;
    for (const std::uint32_t part : falling)
    {
        const std::uint32_t unit = _units.getUnitOf(part);
        const bool isNew = std::find(units.begin(), units.end(), unit) != units.end();
        if (isNew && !_queue->addWithAllBefore(unit, step)) return false;
        UnitList shortest;
        for (const PartLink& joint : _graph.getJointsAbove(part))
        {
            UnitList longer = step;
            if (_isPlaced[joint.part] || !_queue->addWithAllBefore(_units.getUnitOf(joint.part), longer)) continue;
            if (shortest.empty() || longer.size() < shortest.size()) shortest = longer;
        }
        if (!shortest.empty()) step = shortest;
    }
    // The other units of the step, as many as fit.
    for (const std::uint32_t unit : units)
        if (UnitList longer = step;
            _queue->addWithAllBefore(unit, longer) && _queue->getWeight(longer) <= UnitQueue::MOST &&
            _queue->countUnmirroredLarge(longer) == _queue->countUnmirroredLarge(step) && canShow(longer, true))
            step = longer;
    if (step.size() <= 1 || !_queue->isOneStep(step) || !findFalling(step).empty()) return false;
    place(step, true);
    return true;
}

/** Place other units, and these later. */
bool StepBuilder::postpone(const UnitList& units, const std::vector<std::uint32_t>& falling)
{
    bool hasChanged = false;
    for (const std::uint32_t part : falling)
    {
        const std::uint32_t unit = _units.getUnitOf(part);
        if (std::find(units.begin(), units.end(), unit) == units.end() || _isDelayed[unit]) continue;
        _isDelayed[unit] = true;
        hasChanged = true;
    }
    if (!hasChanged) return false;
    UnitList others = propose();
    shorten(others);
    if (_queue->getWeight(others) < UnitQueue::LEAST || !findFalling(others).empty()) return false;
    place(others, true);
    return true;
}

/** Place units after which parts fall, whatever is done, when no others can be placed: a person has to hold the parts
 * from then on.
 * @return whether the situation has changed. */
bool StepBuilder::defer(const UnitList& units, const std::vector<std::uint32_t>& falling)
{
    std::vector<std::uint32_t> added;
    for (const std::uint32_t unit : units)
        added.insert(added.end(), _units.getUnits()[unit].parts.begin(), _units.getUnits()[unit].parts.end());
    const auto firstStanding = std::partition(
        added.begin(), added.end(),
        [&](std::uint32_t part) { return std::find(falling.begin(), falling.end(), part) != falling.end(); });
    if (firstStanding != added.begin()) added.erase(firstStanding, added.end()); // otherwise they let others fall
    const bool hasChanged =
        std::any_of(added.begin(), added.end(), [this](std::uint32_t part) { return !_isDeferred[part]; });
    for (const std::uint32_t part : added)
        _isDeferred[part] = true;
    return hasChanged;
}

/** Let the falling parts hang from those above them. */
bool StepBuilder::hang(const UnitList& units, const std::vector<std::uint32_t>& falling)
{
    std::vector<std::uint32_t> hung;
    for (const std::uint32_t part : falling)
    {
        const std::uint32_t unit = _units.getUnitOf(part);
        const bool isNew = std::find(units.begin(), units.end(), unit) != units.end();
        if (!isNew || _isHung[part] || _graph.isOnBase(part) || _graph.getJointsAbove(part).empty()) continue;
        _isHung[part] = true;
        hung.push_back(part);
    }
    if (hung.empty()) return false;
    BuildingUnits grouped = _units;
    grouped.group(_isPlaced, _isHung);
    // Parts that are pressed on would have to be pushed in between others.
    if (std::any_of(hung.begin(), hung.end(), [&grouped](std::uint32_t part) { return grouped.isPressedOn(part); }))
    {
        for (const std::uint32_t part : hung)
            _isHung[part] = false;
        return false;
    }
    regroup();
    return true;
}

} // namespace osgLego
