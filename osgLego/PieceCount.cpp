#include <osgLego/PieceCount.h>

#include <osgLego/data/UnionFind.h>
#include <osgLego/stability/JointGraph.h>

#include <cstdint>
#include <numeric>
#include <optional>

namespace osgLego
{

std::size_t countPieces(const BrickModel& model, BuildingBase base)
{
    std::vector<std::uint32_t> order(model.getParts().size());
    std::iota(order.begin(), order.end(), 0u);
    const std::vector<std::size_t> counts = countPiecesInOrder(model, order, base);
    return counts.empty() ? 0 : counts.back();
}

std::vector<std::size_t> countPiecesInOrder(const BrickModel& model, std::span<const std::uint32_t> order,
                                            BuildingBase base)
{
    const JointGraph graph(createBuildingBoxes(model));
    UnionFind sets;
    sets.reset(graph.getNumParts());
    std::vector<bool> isPlaced(graph.getNumParts(), false);
    std::optional<std::uint32_t> onPlate;
    std::size_t numPieces = 0;
    std::vector<std::size_t> counts;
    counts.reserve(order.size());
    const auto join = [&](std::uint32_t a, std::uint32_t b)
    { numPieces -= sets.join(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)) ? 1 : 0; };
    for (const std::uint32_t part : order)
    {
        isPlaced[part] = true;
        ++numPieces;
        for (const auto& joints : {graph.getJointsAbove(part), graph.getJointsBelow(part)})
            for (const PartLink& joint : joints)
                if (isPlaced[joint.part]) join(part, joint.part);
        if (base == BuildingBase::PLATE && graph.isOnBase(part))
        {
            if (!onPlate) onPlate = part;
            join(*onPlate, part);
        }
        counts.push_back(numPieces);
    }
    return counts;
}

} // namespace osgLego
