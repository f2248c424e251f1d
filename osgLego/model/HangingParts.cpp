#include <osgLego/model/HangingParts.h>

#include <osgLego/data/UnionFind.h>
#include <osgLego/model/LaidBox.h>

#include <algorithm>
#include <map>
#include <utility>

namespace osgLego
{

namespace
{

std::vector<BuildingBox> toBoxes(const LaidParts& parts)
{
    std::vector<BuildingBox> boxes;
    boxes.reserve(parts.size());
    for (const LaidPart& part : parts)
        boxes.push_back(toBox(part));
    return boxes;
}

} // namespace

HangingParts::HangingParts(const LaidParts& parts) : _graph(toBoxes(parts)), _hangs(parts.size(), true)
{
    for (std::uint32_t part = 0; part < parts.size(); ++part)
    {
        if (_graph.isOnBase(part)) support(part);
        visitCells(_graph.getBox(part), [&](const glm::ivec3& cell) { _parts.emplace(toCellKey(cell), part); });
    }
}

std::vector<std::vector<std::uint32_t>> HangingParts::getGroups() const
{
    UnionFind sets;
    sets.reset(_hangs.size());
    for (std::uint32_t part = 0; part < _hangs.size(); ++part)
        for (const PartLink& joint : _graph.getJointsAbove(part))
            if (_hangs[part] && _hangs[joint.part])
                sets.join(static_cast<std::int32_t>(part), static_cast<std::int32_t>(joint.part));
    std::map<std::int32_t, std::vector<std::uint32_t>> bySet;
    for (std::uint32_t part = 0; part < _hangs.size(); ++part)
        if (_hangs[part]) bySet[sets.find(static_cast<std::int32_t>(part))].push_back(part);
    std::vector<std::vector<std::uint32_t>> groups;
    groups.reserve(bySet.size());
    for (auto& [set, group] : bySet)
        groups.push_back(std::move(group));
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& group, const auto& other) { return group.size() > other.size(); });
    return groups;
}

std::vector<std::uint32_t> HangingParts::findAbove(std::uint32_t part) const
{
    if (!_hangs[part]) return {};
    std::vector<bool> isFound(_hangs.size(), false);
    std::vector<std::uint32_t> found{part};
    isFound[part] = true;
    for (std::size_t index = 0; index < found.size(); ++index)
        for (const PartLink& joint : _graph.getJointsAbove(found[index]))
        {
            if (!_hangs[joint.part] || isFound[joint.part]) continue;
            isFound[joint.part] = true;
            found.push_back(joint.part);
        }
    return found;
}

bool HangingParts::isAt(const glm::ivec3& cell) const
{
    const auto part = _parts.find(toCellKey(cell));
    return part != _parts.end() && _hangs[part->second];
}

void HangingParts::supportAt(const glm::ivec3& cell)
{
    if (isAt(cell)) support(_parts.at(toCellKey(cell)));
}

void HangingParts::support(std::uint32_t part)
{
    for (const std::uint32_t above : findAbove(part))
        _hangs[above] = false;
}

} // namespace osgLego
