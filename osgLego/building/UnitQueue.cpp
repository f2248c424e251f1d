#include <osgLego/building/UnitQueue.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace osgLego
{

UnitQueue::UnitQueue(const BuildingUnits& units, const PartOrder& order, const Symmetry& symmetry) :
    _units(units), _order(order), _symmetry(symmetry), _before(units.getUnits().size()),
    _isTaken(units.getUnits().size(), false), _numOpen(units.getUnits().size())
{
    for (std::uint32_t unit = 0; unit < _numOpen; ++unit)
    {
        _ranks.push_back(order.getRank(getLastPart(unit)));
        _numBefore.push_back(units.getUnits()[unit].numBefore);
        for (const std::uint32_t next : units.getUnits()[unit].next)
            _before[next].push_back(unit);
    }
    for (std::uint32_t unit = 0; unit < _numOpen; ++unit)
        if (_numBefore[unit] == 0) _ready.insert(getKey(unit));
}

/** The part whose rank is that of its unit. */
std::uint32_t UnitQueue::getLastPart(std::uint32_t unit) const
{
    const std::vector<std::uint32_t>& parts = _units.getUnits()[unit].parts;
    return *std::max_element(parts.begin(), parts.end(),
                             [this](std::uint32_t a, std::uint32_t b)
                             { return _order.getRank(a) < _order.getRank(b); });
}

std::size_t UnitQueue::getWeight(const UnitList& units, std::size_t largeWeight) const
{
    std::size_t weight = 0;
    for (const std::uint32_t unit : units)
        weight += isLarge(unit)      ? largeWeight
                  : isSubmodel(unit) ? SUBMODEL_WEIGHT
                                     : _units.getUnits()[unit].parts.size();
    return weight;
}

void UnitQueue::release(std::uint32_t unit)
{
    for (const std::uint32_t next : _units.getUnits()[unit].next)
        if (--_numBefore[next] == 0 && !_isTaken[next]) _ready.insert(getKey(next));
}

void UnitQueue::withdraw(std::uint32_t unit)
{
    for (const std::uint32_t next : _units.getUnits()[unit].next)
        if (_numBefore[next]++ == 0) _ready.erase(getKey(next));
}

void UnitQueue::take(const UnitList& units)
{
    for (const std::uint32_t unit : units)
    {
        _ready.erase(getKey(unit));
        _isTaken[unit] = true;
        release(unit);
    }
    _numOpen -= units.size();
}

/** A unit of a cycle of units, each of which has to be placed before the next: the first that a part in place holds
 * from below, or, if there is none, the first. */
std::uint32_t UnitQueue::findForced() const
{
    const auto getForcedKey = [this](std::uint32_t unit) { return std::pair(!isHeld(unit), getKey(unit)); };
    std::uint32_t best = BuildingUnits::NONE;
    for (std::uint32_t unit = 0; unit < _ranks.size(); ++unit)
        if (!_isTaken[unit] && (best == BuildingUnits::NONE || getForcedKey(unit) < getForcedKey(best))) best = unit;
    return best;
}

bool UnitQueue::isHeld(std::uint32_t unit) const
{
    const auto isInPlace = [this](const PartLink& joint)
    {
        const std::uint32_t below = _units.getUnitOf(joint.part);
        return below == BuildingUnits::NONE || _isTaken[below];
    };
    const std::vector<std::uint32_t>& parts = _units.getUnits()[unit].parts;
    return std::any_of(parts.begin(), parts.end(),
                       [&](std::uint32_t part)
                       {
                           const auto joints = _units.getGraph().getJointsBelow(part);
                           return std::any_of(joints.begin(), joints.end(), isInPlace);
                       });
}

/** The units to be placed next, more than fit into a step. Parts above a submodel come in a later step. */
UnitList UnitQueue::lookAhead(const std::vector<bool>& isAvoided)
{
    UnitList units;
    UnitList avoided;
    std::size_t weight = 0;
    while (weight <= MOST + LEAST && !_ready.empty())
    {
        const std::uint32_t unit = _ready.begin()->second;
        _ready.erase(_ready.begin());
        if ((!isAvoided.empty() && isAvoided[unit]) || isAfterSubmodel(unit, units))
        {
            avoided.push_back(unit);
            continue;
        }
        units.push_back(unit);
        weight += getWeight({unit});
        release(unit);
    }
    for (const std::uint32_t unit : units)
        withdraw(unit);
    for (const UnitList* list : {&units, &avoided})
        for (const std::uint32_t unit : *list)
            if (_numBefore[unit] == 0) _ready.insert(getKey(unit));
    if (units.empty() && avoided.empty()) units.push_back(findForced());
    return units;
}

/** Whether a unit is a part that must be placed after a submodel among others. */
bool UnitQueue::isAfterSubmodel(std::uint32_t unit, const UnitList& others) const
{
    if (isSubmodel(unit)) return false;
    return std::any_of(others.begin(), others.end(),
                       [&](std::uint32_t other)
                       {
                           const UnitList& next = _units.getUnits()[other].next;
                           return isSubmodel(other) && std::binary_search(next.begin(), next.end(), unit);
                       });
}

UnitList UnitQueue::propose(const std::vector<bool>& isAvoided)
{
    UnitList units = lookAhead(isAvoided);
    units.resize(chooseLength(units));
    return units;
}

/** The number of units, of those that follow, that make the best step. */
std::size_t UnitQueue::chooseLength(const UnitList& units) const
{
    std::size_t best = 0;
    int lowest = std::numeric_limits<int>::max();
    std::size_t weight = 0;
    for (std::size_t length = 1; length <= units.size(); ++length)
    {
        weight += getWeight({units[length - 1]});
        if (weight > MOST) break;
        const int penalty = getPenalty(units, length, weight);
        if (penalty > lowest) continue;
        lowest = penalty;
        best = length;
    }
    return best;
}

int UnitQueue::getPenalty(const UnitList& units, std::size_t length, std::size_t weight) const
{
    constexpr int TOO_FEW = 40;
    constexpr int FEW_LEFT = 20;
    constexpr int SPLIT_TWINS = 12;
    constexpr int MANY = 4;
    constexpr int WITHIN_GROUP = 3;
    constexpr int UNMIRRORED_LARGE = 12;
    int penalty = std::abs(static_cast<int>(weight) - static_cast<int>(USUAL));
    if (weight < LEAST) penalty += TOO_FEW;
    if (weight > USUAL_MOST) penalty += MANY;
    penalty += UNMIRRORED_LARGE * countUnmirroredLarge(std::span(units).first(length));
    if (length == units.size()) return penalty;
    const std::uint32_t last = units[length - 1];
    const std::uint32_t next = units[length];
    if (areTwins(last, next)) penalty += SPLIT_TWINS;
    if (_order.getGroup(getLastPart(last)) == _order.getGroup(getLastPart(next))) penalty += WITHIN_GROUP;
    if (_numOpen == units.size() && getWeight(units) - weight < LEAST) penalty += FEW_LEFT;
    return penalty;
}

int UnitQueue::countUnmirroredLarge(std::span<const std::uint32_t> units) const
{
    int count = 0;
    std::uint32_t last = BuildingUnits::NONE;
    for (const std::uint32_t unit : units)
    {
        if (!isLarge(unit)) continue;
        if (last != BuildingUnits::NONE && !areTwins(last, unit)) ++count;
        last = unit;
    }
    return count;
}

bool UnitQueue::areTwins(std::uint32_t unit, std::uint32_t other) const
{
    const std::vector<std::uint32_t>& parts = _units.getUnits()[unit].parts;
    const std::uint32_t twin = _symmetry.getTwin(parts.front());
    return twin != Symmetry::NONE && _units.getUnitOf(twin) == other;
}

/** @param openWeight of the units that follow this one. Counting them on the way limits the depth of the recursion,
 * also for units of which each has to be placed before the other. */
bool UnitQueue::addWithAllBefore(std::uint32_t unit, UnitList& units, std::size_t openWeight) const
{
    if (std::find(units.begin(), units.end(), unit) != units.end()) return true;
    openWeight += getWeight({unit}, SUBMODEL_WEIGHT);
    if (getWeight(units, SUBMODEL_WEIGHT) + openWeight > MOST) return false;
    for (const std::uint32_t before : _before[unit])
        if (!_isTaken[before] && !addWithAllBefore(before, units, openWeight)) return false;
    units.push_back(unit);
    return true;
}

bool UnitQueue::isOneStep(const UnitList& units) const
{
    return std::none_of(units.begin(), units.end(), [&](std::uint32_t unit) { return isAfterSubmodel(unit, units); });
}

} // namespace osgLego
