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
    _sets.reset(_graph.getNumParts());
    findSupported(isPlaced, isHung);
    hangGroups(isPlaced);
    do
    {
        createUnits(isPlaced);
        linkUnits();
    } while (joinCycles());
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
    for (std::uint32_t part = 0; part < _graph.getNumParts(); ++part)
        for (const PartLink& joint : _graph.getJointsAbove(part))
            if (!_isSupported[part] && !_isSupported[joint.part])
                _sets.join(static_cast<std::int32_t>(part), static_cast<std::int32_t>(joint.part));
    std::map<std::int32_t, std::vector<std::uint32_t>> groups;
    for (std::uint32_t part = 0; part < _graph.getNumParts(); ++part)
        if (!_isSupported[part] && !isPlaced[part]) groups[_sets.find(static_cast<std::int32_t>(part))].push_back(part);
    for (const auto& [set, hanging] : groups)
        if (const std::uint32_t holder = chooseHolder(hanging, isPlaced); holder != NONE)
            _sets.join(set, static_cast<std::int32_t>(holder));
}

/** The supported part from which hanging parts hang best: by many studs, and near their centre. NONE if all parts above
 * them are in place, which is possible only if the caller declared them as hanging, or if parts were placed regardless
 * of the order. */
std::uint32_t BuildingUnits::chooseHolder(const std::vector<std::uint32_t>& hanging,
                                          const std::vector<bool>& isPlaced) const
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
}

/** A unit must be placed before units with a part above one of its parts, since hands come from above. */
void BuildingUnits::linkUnits()
{
    for (Unit& unit : _units)
    {
        const std::uint32_t number = _unitOf[unit.parts.front()];
        for (const std::uint32_t part : unit.parts)
            for (const PartLink& link : _graph.getNextAbove(part))
                if (const std::uint32_t other = _unitOf[link.part]; other != NONE && other != number)
                    unit.next.push_back(other);
        std::sort(unit.next.begin(), unit.next.end());
        unit.next.erase(std::unique(unit.next.begin(), unit.next.end()), unit.next.end());
        for (const std::uint32_t other : unit.next)
            ++_units[other].numBefore;
    }
}

/** Join units of which each has to be placed before the other, if joints connect them.
 * @return whether any were joined. */
bool BuildingUnits::joinCycles()
{
    bool hasJoined = false;
    const auto cycles = findStronglyConnected(_units.size(), [this](std::uint32_t unit)
                                              { return std::span<const std::uint32_t>(_units[unit].next); });
    std::vector<bool> isInCycle(_units.size(), false);
    for (const std::vector<std::uint32_t>& cycle : cycles)
    {
        for (const std::uint32_t unit : cycle)
            isInCycle[unit] = true;
        for (const std::uint32_t unit : cycle)
            for (const std::uint32_t part : _units[unit].parts)
                for (const PartLink& joint : _graph.getJointsAbove(part))
                    if (const std::uint32_t other = _unitOf[joint.part]; other != NONE && isInCycle[other])
                        hasJoined =
                            _sets.join(static_cast<std::int32_t>(part), static_cast<std::int32_t>(joint.part)) ||
                            hasJoined;
        for (const std::uint32_t unit : cycle)
            isInCycle[unit] = false;
    }
    return hasJoined;
}

} // namespace osgLego
