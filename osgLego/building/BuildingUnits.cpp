#include <osgLego/building/BuildingUnits.h>

#include <osgLego/building/StronglyConnected.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>

namespace osgLego
{

namespace
{

/** Twice the centre of a box. */
glm::ivec3 getCenter(const BuildingBox& box)
{
    return box.lower + box.upper;
}

} // namespace

void BuildingUnits::group(const std::vector<bool>& isPlaced, const std::vector<bool>& isHung)
{
    findSupported(isPlaced, isHung);
    hangGroups(isPlaced);
    for (bool hasChanged = true; hasChanged;)
    {
        createUnits(isPlaced);
        linkUnits();
        const std::vector<UnitNumbers> cycles = findCycles();
        hasChanged = joinCycles(cycles);
        if (!breakCycles(cycles, isHung)) continue;
        hangGroups(isPlaced);
        hasChanged = true;
    }
}

void BuildingUnits::findSupported(const std::vector<bool>& isPlaced, const std::vector<bool>& isHung)
{
    _isSupported.assign(_graph.getNumParts(), false);
    std::vector<std::uint32_t> reached;
    const auto reach = [&](std::uint32_t part)
    {
        if (_isSupported[part]) return;
        _isSupported[part] = true;
        reached.push_back(part);
    };
    for (std::uint32_t part = 0; part < _graph.getNumParts(); ++part)
        if (isPlaced[part] || _graph.isOnBase(part)) reach(part);
    while (!reached.empty())
    {
        const std::uint32_t part = reached.back();
        reached.pop_back();
        for (const PartLink& joint : _graph.getJointsAbove(part))
            if (!isHung[joint.part]) reach(joint.part);
    }
}

/** Put each connected group of hanging parts into a set with the part that holds it. */
void BuildingUnits::hangGroups(const std::vector<bool>& isPlaced)
{
    _sets.reset(_graph.getNumParts());
    _isPressedOn.assign(_graph.getNumParts(), false);
    _pressed.clear();
    UnionFind hanging;
    hanging.reset(_graph.getNumParts());
    for (std::uint32_t part = 0; part < _graph.getNumParts(); ++part)
        for (const PartLink& joint : _graph.getJointsAbove(part))
            if (!_isSupported[part] && !_isSupported[joint.part])
                hanging.join(static_cast<std::int32_t>(part), static_cast<std::int32_t>(joint.part));
    std::map<std::int32_t, PartList> groups;
    for (std::uint32_t part = 0; part < _graph.getNumParts(); ++part)
        if (!_isSupported[part] && !isPlaced[part])
            groups[hanging.find(static_cast<std::int32_t>(part))].push_back(part);
    for (const auto& [set, parts] : groups)
        hangGroup(parts, isPlaced);
}

void BuildingUnits::hangGroup(const PartList& hanging, const std::vector<bool>& isPlaced)
{
    const std::uint32_t holder = chooseHolder(hanging, isPlaced);
    const bool isTooLarge = hanging.size() + (holder == NONE ? 0 : 1) > _mostParts;
    if (isTooLarge || _isAlone[hanging.front()]) return pressOn(hanging, isPlaced);
    for (const std::uint32_t part : hanging)
        _sets.join(static_cast<std::int32_t>(part), static_cast<std::int32_t>(hanging.front()));
    if (holder != NONE) _sets.join(static_cast<std::int32_t>(hanging.front()), static_cast<std::int32_t>(holder));
}

/** Let hanging parts be placed one by one: first those below parts that do not hang, and then their neighbours. */
void BuildingUnits::pressOn(const PartList& hanging, const std::vector<bool>& isPlaced)
{
    PartList reached;
    const auto reach = [&](std::uint32_t part, std::uint32_t from)
    {
        if (_isPressedOn[part]) return;
        _isPressedOn[part] = true;
        reached.push_back(part);
        if (!isPlaced[from]) _pressed.emplace_back(from, part);
    };
    const auto isFree = [this](const PartLink& joint) { return !_isSupported[joint.part]; };
    for (const bool isFromAbove : {true, false})
        for (const std::uint32_t part : hanging)
        {
            const auto joints = isFromAbove ? _graph.getJointsAbove(part) : _graph.getJointsBelow(part);
            const auto holder = std::find_if_not(joints.begin(), joints.end(), isFree);
            if (holder != joints.end() && (isFromAbove || reached.empty())) reach(part, holder->part);
        }
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (const auto& joints : {_graph.getJointsBelow(reached[next]), _graph.getJointsAbove(reached[next])})
            for (const PartLink& joint : joints)
                if (isFree(joint) && !isPlaced[joint.part]) reach(joint.part, reached[next]);
}

/** The supported part from which hanging parts hang best: by many studs, and near their centre. NONE if all parts above
 * them are in place, which is possible only if the caller declared them as hanging, or if parts were placed regardless
 * of the order. */
std::uint32_t BuildingUnits::chooseHolder(const PartList& hanging, const std::vector<bool>& isPlaced) const
{
    std::map<std::uint32_t, int> studs;
    glm::ivec3 sum(0);
    for (const std::uint32_t part : hanging)
    {
        sum += getCenter(_graph.getBox(part));
        for (const PartLink& joint : _graph.getJointsAbove(part))
            if (_isSupported[joint.part] && !isPlaced[joint.part]) studs[joint.part] += joint.studs;
    }
    const glm::ivec3 center = sum / static_cast<int>(hanging.size());
    const auto score = [&](const auto& holder)
    {
        constexpr int STUD = 4; // weighs as much as two studs of distance
        const BuildingBox& box = _graph.getBox(holder.first);
        const glm::ivec3 way = getCenter(box) - center;
        return std::tuple(STUD * holder.second - std::abs(way.x) - std::abs(way.y), -box.lower.z);
    };
    const auto best =
        std::max_element(studs.begin(), studs.end(), [&](const auto& a, const auto& b) { return score(a) < score(b); });
    return best == studs.end() ? NONE : best->first;
}

void BuildingUnits::createUnits(const std::vector<bool>& isPlaced)
{
    _units.clear();
    _unitOf.assign(_graph.getNumParts(), NONE);
    for (std::uint32_t part = 0; part < _graph.getNumParts(); ++part)
    {
        if (isPlaced[part]) continue;
        // The lowest part of a set represents it, so it has a unit when the others come.
        const auto first = static_cast<std::uint32_t>(_sets.find(static_cast<std::int32_t>(part)));
        if (first == part)
        {
            _unitOf[part] = static_cast<std::uint32_t>(_units.size());
            _units.emplace_back();
        }
        _unitOf[part] = _unitOf[first];
        _units[_unitOf[part]].parts.push_back(part);
    }
    for (Unit& unit : _units)
        if (unit.parts.size() > 1 && !unit.isSubmodel()) sortInHand(unit.parts);
}

/** Sort parts so that each is joined to those before: first the part on which the others are pressed. */
void BuildingUnits::sortInHand(PartList& parts) const
{
    std::stable_partition(parts.begin(), parts.end(), [this](std::uint32_t part) { return _isSupported[part]; });
    for (auto next = parts.begin() + 1; next != parts.end(); ++next)
    {
        const auto isJoined = [&](std::uint32_t part)
        {
            const auto isBefore = [&](const PartLink& joint)
            { return std::find(parts.begin(), next, joint.part) != next; };
            const auto above = _graph.getJointsAbove(part);
            const auto below = _graph.getJointsBelow(part);
            return std::any_of(above.begin(), above.end(), isBefore) ||
                   std::any_of(below.begin(), below.end(), isBefore);
        };
        std::iter_swap(next, std::find_if(next, parts.end() - 1, isJoined));
    }
}

/** A unit must be placed before units with a part above one of its parts, since hands come from above, except for parts
 * that are pressed on from below. */
void BuildingUnits::linkUnits()
{
    for (const auto& [holder, part] : _pressed)
        _units[_unitOf[holder]].next.push_back(_unitOf[part]);
    for (Unit& unit : _units)
    {
        const std::uint32_t number = _unitOf[unit.parts.front()];
        for (const std::uint32_t part : unit.parts)
            for (const PartLink& link : _graph.getNextAbove(part))
                if (const std::uint32_t other = _unitOf[link.part];
                    other != NONE && other != number && !_isPressedOn[part])
                    unit.next.push_back(other);
        std::sort(unit.next.begin(), unit.next.end());
        unit.next.erase(std::unique(unit.next.begin(), unit.next.end()), unit.next.end());
        for (const std::uint32_t other : unit.next)
            ++_units[other].numBefore;
    }
}

std::vector<BuildingUnits::UnitNumbers> BuildingUnits::findCycles() const
{
    return findStronglyConnected(_units.size(), [this](std::uint32_t unit)
                                 { return std::span<const std::uint32_t>(_units[unit].next); });
}

/** Whether units would make a unit that is too large. */
bool BuildingUnits::isTooLarge(const UnitNumbers& units) const
{
    std::size_t numParts = 0;
    for (const std::uint32_t unit : units)
        numParts += _units[unit].parts.size();
    return numParts > _mostParts;
}

/** Join units of which each has to be placed before the other, if joints connect them, and if they are not too large.
 * @return whether any were joined. */
bool BuildingUnits::joinCycles(const std::vector<UnitNumbers>& cycles)
{
    bool hasJoined = false;
    for (const UnitNumbers& cycle : cycles)
    {
        if (isTooLarge(cycle)) continue;
        for (const std::uint32_t unit : cycle)
            for (const std::uint32_t part : _units[unit].parts)
                for (const PartLink& joint : _graph.getJointsAbove(part))
                    if (std::binary_search(cycle.begin(), cycle.end(), _unitOf[joint.part]))
                        hasJoined =
                            _sets.join(static_cast<std::int32_t>(part), static_cast<std::int32_t>(joint.part)) ||
                            hasJoined;
    }
    return hasJoined;
}

/** Take the hanging parts out of a unit of each cycle that is too large, the one with most links to others.
 * @return whether there was any. */
bool BuildingUnits::breakCycles(const std::vector<UnitNumbers>& cycles, const std::vector<bool>& isHung)
{
    bool hasBroken = false;
    for (const UnitNumbers& cycle : cycles)
    {
        if (!isTooLarge(cycle)) continue;
        std::map<std::uint32_t, int> numLinks; // of units in which parts hang
        for (const std::uint32_t unit : cycle)
            for (const std::uint32_t next : _units[unit].next)
                if (std::binary_search(cycle.begin(), cycle.end(), next))
                    for (const std::uint32_t end : {unit, next})
                        if (canBeSplit(end, isHung)) ++numLinks[end];
        const auto most = std::max_element(numLinks.begin(), numLinks.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        if (most == numLinks.end()) continue;
        for (const std::uint32_t part : _units[most->first].parts)
            _isAlone[part] = _isAlone[part] || !_isSupported[part];
        hasBroken = true;
    }
    return hasBroken;
}

/** Whether the hanging parts of a unit can be placed one by one, after the part that holds them. There is no room for
 * parts that hang although there are joints below them. */
bool BuildingUnits::canBeSplit(std::uint32_t unit, const std::vector<bool>& isHung) const
{
    const PartList& parts = _units[unit].parts;
    const auto isSupported = [this](std::uint32_t part) { return _isSupported[part]; };
    return std::any_of(parts.begin(), parts.end(), isSupported) &&
           !std::all_of(parts.begin(), parts.end(), isSupported) &&
           std::none_of(parts.begin(), parts.end(), [&isHung](std::uint32_t part) { return isHung[part]; });
}

} // namespace osgLego
