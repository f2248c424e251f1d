#include <osgLego/PieceCount.h>

#include <osgLego/data/UnionFind.h>
#include <osgLego/stability/JointGraph.h>

#include <cstdint>
#include <optional>

namespace osgLego
{

std::size_t countPieces(const BrickModel& model, BuildingBase base)
{
    const JointGraph graph(createBuildingBoxes(model));
    UnionFind sets;
    sets.reset(graph.getNumParts());
    std::size_t numPieces = graph.getNumParts();
    const auto join = [&](std::uint32_t a, std::uint32_t b)
    { numPieces -= sets.join(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)) ? 1 : 0; };
    std::optional<std::uint32_t> onPlate;
    for (std::uint32_t part = 0; part < graph.getNumParts(); ++part)
    {
        for (const PartLink& joint : graph.getJointsAbove(part))
            join(part, joint.part);
        if (base != BuildingBase::PLATE || !graph.isOnBase(part)) continue;
        if (!onPlate) onPlate = part;
        join(*onPlate, part);
    }
    return numPieces;
}

} // namespace osgLego
