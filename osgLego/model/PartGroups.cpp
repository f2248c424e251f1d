#include <osgLego/model/PartGroups.h>

#include <osgLego/data/CellKeys.h>
#include <osgLego/data/UnionFind.h>
#include <osgLego/model/LaidBox.h>
#include <osgLego/stability/JointGraph.h>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace osgLego
{

namespace
{

/** The groups of members that are in one set. @param sets of the indices of members. */
PartGroups toGroups(UnionFind& sets, const std::vector<std::uint32_t>& members)
{
    std::map<std::int32_t, std::vector<std::uint32_t>> byRoot;
    for (std::size_t i = 0; i < members.size(); ++i)
        byRoot[sets.find(static_cast<std::int32_t>(i))].push_back(members[i]);
    PartGroups groups;
    groups.reserve(byRoot.size());
    for (auto& [root, group] : byRoot)
        groups.push_back(std::move(group));
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& group, const auto& other) { return group.size() > other.size(); });
    return groups;
}

/** For each part, whether an upward path of joints from the lowest layer reaches it. */
std::vector<bool> findReached(const JointGraph& graph)
{
    std::vector<bool> isReached(graph.getNumParts(), false);
    std::vector<std::uint32_t> reached;
    const auto reach = [&](std::uint32_t part)
    {
        if (!isReached[part]) reached.push_back(part);
        isReached[part] = true;
    };
    for (std::uint32_t part = 0; part < graph.getNumParts(); ++part)
        if (graph.isOnBase(part)) reach(part);
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (const PartLink& joint : graph.getJointsAbove(reached[next]))
            reach(joint.part);
    return isReached;
}

} // namespace

PartGroups findTouchingGroups(const LaidParts& parts, const std::vector<std::uint32_t>& members)
{
    std::unordered_map<CellKey, std::int32_t> cells;
    for (std::size_t i = 0; i < members.size(); ++i)
        visitCells(toBox(parts[members[i]]),
                   [&](const glm::ivec3& cell) { cells.emplace(toCellKey(cell), static_cast<std::int32_t>(i)); });
    UnionFind sets;
    sets.reset(members.size());
    for (const auto& [key, member] : cells)
        for (const CellKey step : {CELL_RIGHT, CELL_BEHIND, CELL_ABOVE})
            if (const auto next = cells.find(key + step); next != cells.end()) sets.join(member, next->second);
    return toGroups(sets, members);
}

PartGroups findHangingGroups(const LaidParts& parts)
{
    std::vector<BuildingBox> boxes;
    boxes.reserve(parts.size());
    for (const LaidPart& part : parts)
        boxes.push_back(toBox(part));
    const JointGraph graph(std::move(boxes));
    const std::vector<bool> isReached = findReached(graph);
    std::vector<std::uint32_t> hanging;
    std::vector<std::int32_t> places(parts.size()); // in `hanging`
    for (std::uint32_t part = 0; part < parts.size(); ++part)
        if (!isReached[part])
        {
            places[part] = static_cast<std::int32_t>(hanging.size());
            hanging.push_back(part);
        }
    UnionFind sets;
    sets.reset(hanging.size());
    for (const std::uint32_t part : hanging)
        for (const PartLink& joint : graph.getJointsAbove(part))
            if (!isReached[joint.part]) sets.join(places[part], places[joint.part]);
    return toGroups(sets, hanging);
}

} // namespace osgLego
