#include "SubmodelTurn.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace osgLego
{

namespace
{

/** A part to the right, to the back and upwards from a corner of its submodel. */
struct PlacedKind
{
    std::array<int, 3> lower{};
    std::array<int, 3> size{};
    std::size_t kind = 0;

    bool operator==(const PlacedKind&) const = default;
    bool operator<(const PlacedKind& other) const
    {
        return std::tie(lower, size, kind) < std::tie(other.lower, other.size, other.kind);
    }
};

PlacedKind place(const BrickGrid& grid, const Part& part, std::size_t kind)
{
    const glm::ivec3 cell = part.getCell();
    const glm::ivec3 size = part.getSize();
    if (grid.upAxis == UpAxis::Z) return {{cell.x, cell.y, cell.z}, {size.x, size.y, size.z}, kind};
    return {{cell.x, -cell.z - size.z, cell.y}, {size.x, size.z, size.y}, kind}; // z points to the front
}

/** Turn a part by a quarter, counter-clockwise from above. */
PlacedKind turn(const PlacedKind& own)
{
    return {
        {-own.lower[1] - own.size[1], own.lower[0], own.lower[2]}, {own.size[1], own.size[0], own.size[2]}, own.kind};
}

/** Parts, turned, from the lowest cell of all, in ascending order, and their indices. */
std::vector<std::pair<PlacedKind, std::uint32_t>> arrange(const BrickModel& model, std::span<const std::size_t> kinds,
                                                          int turns)
{
    std::vector<std::pair<PlacedKind, std::uint32_t>> parts;
    std::array<int, 3> lowest{};
    for (std::uint32_t part = 0; part < kinds.size(); ++part)
    {
        PlacedKind own = place(model.getGrid(), model.getParts()[part], kinds[part]);
        for (int index = 0; index < turns; ++index)
            own = turn(own);
        for (std::size_t axis = 0; axis < lowest.size(); ++axis)
            lowest[axis] = part == 0 ? own.lower[axis] : std::min(lowest[axis], own.lower[axis]);
        parts.emplace_back(own, part);
    }
    for (auto& [own, part] : parts)
        for (std::size_t axis = 0; axis < lowest.size(); ++axis)
            own.lower[axis] -= lowest[axis];
    std::sort(parts.begin(), parts.end());
    return parts;
}

} // namespace

std::optional<SubmodelTurn> SubmodelTurn::find(const BrickModel& submodel, std::span<const std::size_t> kinds,
                                               const BrickModel& other, std::span<const std::size_t> otherKinds)
{
    if (kinds.size() != otherKinds.size()) return std::nullopt;
    const auto parts = arrange(submodel, kinds, 0);
    for (int numTurns = 0; numTurns < NUM_TURNS; ++numTurns)
    {
        const auto turned = arrange(other, otherKinds, numTurns);
        if (!std::equal(parts.begin(), parts.end(), turned.begin(),
                        [](const auto& own, const auto& its) { return own.first == its.first; }))
            continue;
        SubmodelTurn found{numTurns, std::vector<std::uint32_t>(parts.size())};
        for (std::size_t index = 0; index < parts.size(); ++index)
            found.equal[parts[index].second] = turned[index].second;
        return found;
    }
    return std::nullopt;
}

} // namespace osgLego
