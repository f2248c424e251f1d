#include <osgLego/building/StepBuilder.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

StepBuilder::StepBuilder(const JointGraph& graph, FindFalling findFalling, Proceed proceed, StepViews* views) :
    _graph(graph), _symmetry(graph.getBoxes()), _order(graph.getBoxes(), _symmetry),
    _findFalling(std::move(findFalling)), _proceed(std::move(proceed)), _views(views), _units(graph),
    _isPlaced(graph.getNumParts(), false), _isHung(graph.getNumParts(), false), _isLost(graph.getNumParts(), false)
{
}

std::vector<AssemblyStep> StepBuilder::build()
{
    regroup();
    while (!_queue->isEmpty())
    {
        const UnitList units = proposeStep();
        const std::vector<std::uint32_t> falling = findFalling(units);
        if (falling.empty())
            place(units, true);
        else if (!repair(units, falling))
        {
            for (const std::uint32_t part : falling)
                _isLost[part] = true;
            place(units, false);
        }
        if (!_proceed(_numPlaced)) return {};
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
    const std::size_t weight = before.parts.size() + UnitQueue::SUBMODEL_WEIGHT * before.submodels.size();
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
    UnitList units = _queue->propose(_isDelayed);
    if (_queue->getWeight(units) < UnitQueue::LEAST)
    {
        _isDelayed.assign(_isDelayed.size(), false);
        units = _queue->propose(_isDelayed);
    }
    shorten(units);
    return units;
}

/** Whether no part of a step is hidden; parts of submodels may be, since they have steps of their own. */
bool StepBuilder::canShow(const UnitList& units, bool isTurning) const
{
    if (!_views) return true;
    std::vector<std::uint32_t> parts;
    for (const std::uint32_t unit : units)
        if (!_queue->isSubmodel(unit)) parts.push_back(_units.getUnits()[unit].parts.front());
    return _views->canShow(parts, isTurning);
}

/** Leave out the last units if some part is hidden otherwise, and if enough remain; preferably without a turn. */
void StepBuilder::shorten(UnitList& units) const
{
    for (const bool isTurning : {false, true})
        for (UnitList shorter = units; _queue->getWeight(shorter) >= UnitQueue::LEAST; shorter.pop_back())
        {
            const bool leavesOne = shorter.size() < units.size() && _queue->getNumOpen() == shorter.size() + 1;
            if (leavesOne || !canShow(shorter, isTurning)) continue;
            units = shorter;
            return;
        }
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
    for (const std::uint32_t unit : units)
    {
        const std::vector<std::uint32_t>& parts = _units.getUnits()[unit].parts;
        _numPlaced += parts.size();
        shown.insert(shown.end(), parts.begin(), parts.end());
        if (_queue->isSubmodel(unit))
            step.submodels.push_back(parts);
        else
            step.parts.push_back(parts.front());
    }
    if (_views) step.turns = _views->show(shown);
    _steps.push_back(std::move(step));
    mark(units, true);
    _queue->take(units);
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

/** Repair a step with units after which parts fall: place other units, or group the parts in another way.
 * @return whether the situation has changed. */
bool StepBuilder::repair(const UnitList& units, const std::vector<std::uint32_t>& falling)
{
    // If parts fall, all parts above them fall, too.
    const bool isKnown =
        std::any_of(falling.begin(), falling.end(), [this](std::uint32_t part) { return _isLost[part]; });
    return !isKnown && (clamp(units, falling) || postpone(units, falling) || hang(units, falling));
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
        if (UnitList longer = step; _queue->addWithAllBefore(unit, longer) && canShow(longer, true)) step = longer;
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
    UnitList others = _queue->propose(_isDelayed);
    shorten(others);
    if (_queue->getWeight(others) < UnitQueue::LEAST || !findFalling(others).empty()) return false;
    place(others, true);
    return true;
}

/** Let the falling parts hang from those above them. */
bool StepBuilder::hang(const UnitList& units, const std::vector<std::uint32_t>& falling)
{
    bool hasChanged = false;
    for (const std::uint32_t part : falling)
    {
        const std::uint32_t unit = _units.getUnitOf(part);
        const bool isNew = std::find(units.begin(), units.end(), unit) != units.end();
        if (!isNew || _isHung[part] || _graph.isOnBase(part) || _graph.getJointsAbove(part).empty()) continue;
        _isHung[part] = true;
        hasChanged = true;
    }
    if (hasChanged) regroup();
    return hasChanged;
}

} // namespace osgLego
