#include "SubmodelTurn.h"

#include "PlacedBox.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

struct PlacedKind
{
    PlacedBox box;
    std::size_t kind = 0;

    auto getOrder() const
    {
        return std::tie(box.lower.x, box.lower.y, box.lower.z, box.size.x, box.size.y, box.size.z, kind);
    }
    bool operator==(const PlacedKind& other) const { return getOrder() == other.getOrder(); }
    bool operator<(const PlacedKind& other) const { return getOrder() < other.getOrder(); }
};

/** Parts, turned, from the lowest cell of all, in ascending order, and their indices. */
std::vector<std::pair<PlacedKind, std::uint32_t>> arrange(const BrickModel& model, std::span<const std::size_t> kinds,
                                                          int turns)
{
    std::vector<std::pair<PlacedKind, std::uint32_t>> parts;
    glm::ivec3 lowest(std::numeric_limits<int>::max());
    for (std::uint32_t part = 0; part < kinds.size(); ++part)
    {
        const PlacedBox box = PlacedBox::create(model.getGrid(), model.getParts()[part]).turn(turns);
        lowest = glm::min(lowest, box.lower);
        parts.push_back({{box, kinds[part]}, part});
    }
    for (auto& [own, part] : parts)
        own.box.lower -= lowest;
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
