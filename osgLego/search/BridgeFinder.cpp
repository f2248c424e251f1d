#include <osgLego/search/BridgeFinder.h>

#include <osgLego/PartType.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace osgLego
{

namespace
{

constexpr int MOST_ADDED = 2;              // parts
constexpr std::size_t MOST_CANDIDATES = 4; // whose connections are examined

} // namespace

const std::vector<BridgeFinder::Piece>& BridgeFinder::find(Index cell, CellLattice::Side side,
                                                           const LayoutRegion& region)
{
    static const std::vector<Piece> none;
    _candidates.clear();
    findParts(cell, side, 1, region);
    if (_sizes.getHeights().size() > 1) findBricks(cell, side, region);
    std::ranges::stable_sort(_candidates, {}, &Candidate::numAdded);
    if (_candidates.size() > MOST_CANDIDATES) _candidates.resize(MOST_CANDIDATES);
    for (const Candidate& candidate : _candidates)
        if (_cut.cover(candidate.bridge, region) && _cut.divide() && _cut.keepsConnections()) return _cut.getPieces();
    return none;
}

/** Try all parts of a height that contain a cell and its neighbour in their lowest layer. */
void BridgeFinder::findParts(Index cell, CellLattice::Side side, int height, const LayoutRegion& region)
{
    const std::size_t along = side == CellLattice::EAST ? 0 : 1;
    for (const auto& [shorter, longer] : PART_SIZES)
        for (const bool isTurned : {false, true})
        {
            if (isTurned && shorter == longer) continue;
            const std::array<int, 2> size = isTurned ? std::array{longer, shorter} : std::array{shorter, longer};
            std::array<int, 2> numOffsets = size;
            --numOffsets[along];
            const PartShape shape{static_cast<std::uint8_t>(size[0]), static_cast<std::uint8_t>(size[1]),
                                  static_cast<std::uint8_t>(height)};
            for (int y = 0; y < numOffsets[1]; ++y)
                for (int x = 0; x < numOffsets[0]; ++x)
                    tryAt(cell, {x, y}, shape, region);
        }
}

/** Try bricks in the layers of the present ones, so that none is cut horizontally. */
void BridgeFinder::findBricks(Index cell, CellLattice::Side side, const LayoutRegion& region)
{
    const CellLattice& lattice = _map.getLattice();
    int last = -1;
    for (const Index anchor : {_map.getAnchor(cell), _map.getAnchor(lattice.getNeighbor(cell, side))})
    {
        const int z = lattice.getZ(anchor);
        if (_map.getShape(anchor).height == 1 || z == last) continue;
        last = z;
        const Index level = lattice.move(cell, CellLattice::BELOW, lattice.getZ(cell) - z);
        if (level != CellLattice::NONE && lattice.getNeighbor(level, side) != CellLattice::NONE)
            findParts(level, side, PartSizes::BRICK_PLATES, region);
    }
}

/** Try the part in which a cell has an offset from the corner. */
void BridgeFinder::tryAt(Index cell, const std::array<int, 2>& offset, const PartShape& shape,
                         const LayoutRegion& region)
{
    const CellLattice& lattice = _map.getLattice();
    const Index column = lattice.move(cell, CellLattice::WEST, offset[0]);
    const Piece bridge{lattice.move(column, CellLattice::SOUTH, offset[1]), shape};
    if (bridge.anchor == CellLattice::NONE || !_cut.cover(bridge, region)) return;
    if (!_cut.touchesSeveral(_components) || !_cut.divide()) return;
    if (_cut.countAdded() <= MOST_ADDED && _cut.touchesAll()) _candidates.push_back({bridge, _cut.countAdded()});
}

} // namespace osgLego
