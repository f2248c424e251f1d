#include <osgLego/search/BridgeJoiner.h>

#include <osgLego/search/LayoutCosts.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace osgLego
{

namespace
{

constexpr int MOST_FAILURES = 6; // at the seams of one component
constexpr int PARTS_NEAR_ALONE = 5;
constexpr int NODES_NEAR_ALONE = 300;

} // namespace

BridgeJoiner::BridgeJoiner(PartMap& map, const PartSizes& sizes) :
    _map(map), _sizes(sizes), _window(map, sizes), _finder(map, sizes, _components)
{
}

void BridgeJoiner::findComponents()
{
    const CellLattice& lattice = _map.getLattice();
    _map.findComponents(_components);
    _numCells.assign(static_cast<std::size_t>(lattice.getNumCells()), 0);
    for (Index cell = 0; cell < lattice.getNumCells(); ++cell)
        ++_numCells[static_cast<std::size_t>(_components.find(cell))];
}

/** List the seams by the size of the smaller component, those of one component in a random order. */
void BridgeJoiner::findSeams(const std::vector<bool>& isActive, LayoutRandom& random)
{
    _seams.clear();
    for (Index cell = 0; cell < _map.getLattice().getNumCells(); ++cell)
    {
        if (!isActive.empty() && !isActive[static_cast<std::size_t>(cell)]) continue;
        addSeam(cell, CellLattice::EAST);
        addSeam(cell, CellLattice::NORTH);
    }
    random.shuffle(_seams);
    std::ranges::stable_sort(_seams, [](const Seam& a, const Seam& b)
                             { return std::pair(a.numCells, a.component) < std::pair(b.numCells, b.component); });
}

/** Add the seam between a cell and its neighbour, if there is one that a part may cover. */
void BridgeJoiner::addSeam(Index cell, CellLattice::Side side)
{
    const CellLattice& lattice = _map.getLattice();
    const Index other = lattice.getNeighbor(cell, side);
    if (other == CellLattice::NONE || _map.getAnchor(other) == _map.getAnchor(cell)) return;
    const Index a = _components.find(cell);
    const Index b = _components.find(other);
    if (a == b || !PartSizes::join(lattice.getColor(cell), lattice.getColor(other))) return;
    const auto sized = [&](Index component)
    { return std::pair(_numCells[static_cast<std::size_t>(component)], component); };
    const auto [numCells, component] = std::min(sized(a), sized(b));
    _seams.push_back({numCells, component, cell, side});
}

bool BridgeJoiner::joinAll(const std::vector<bool>& isActive, LayoutRandom& random,
                           const std::function<bool()>& isCancelled)
{
    const CellLattice& lattice = _map.getLattice();
    const LayoutRegion region{0, lattice.getNumLayers(), 0, lattice.getProblem().size.y, 0, 0, nullptr, &isActive};
    findComponents();
    findSeams(isActive, random);
    Index component = CellLattice::NONE;
    int numFailures = 0;
    for (const Seam& seam : _seams)
    {
        if (isCancelled && isCancelled()) return false;
        if (seam.component != component) numFailures = 0;
        component = seam.component;
        const Index other = lattice.getNeighbor(seam.cell, seam.side);
        if (numFailures == MOST_FAILURES || _components.find(seam.cell) == _components.find(other)) continue;
        if (!join(seam, region, random)) ++numFailures;
    }
    return true;
}

/** @return whether the parts at a seam have changed. */
bool BridgeJoiner::join(const Seam& seam, const LayoutRegion& region, LayoutRandom& random)
{
    const Index anchor = _map.getAnchor(seam.cell);
    const Index other = _map.getAnchor(_map.getLattice().getNeighbor(seam.cell, seam.side));
    const bool isAlone = _map.isAlone(anchor);
    const bool isOtherAlone = _map.isAlone(other);
    if (anchor == other || (isAlone && isOtherAlone)) return false;
    if (isAlone || isOtherAlone) return joinAlone(isAlone ? anchor : other, region, random);
    const std::vector<PartCut::Piece>& pieces = _finder.find(seam.cell, seam.side, region);
    layAll(pieces, region);
    return !pieces.empty();
}

/** Lay a part that touches no part above or below again, together with parts beside it. */
bool BridgeJoiner::joinAlone(Index anchor, const LayoutRegion& region, LayoutRandom& random)
{
    return isReachable(anchor) &&
           _window.improve(anchor, PARTS_NEAR_ALONE, LayoutCosts::HALF_SEAM, region, NODES_NEAR_ALONE, random);
}

/** Whether parts could connect all cells of a part: a part without neighbours above and below is needed otherwise. */
bool BridgeJoiner::isReachable(Index anchor) const
{
    bool isReachable = true;
    _map.visitPart(anchor, [&](Index cell) { isReachable = isReachable && isNearColumn(cell); });
    return isReachable;
}

/** Whether a part, one or two cells wide, may reach from a cell to one that has another above or below. */
bool BridgeJoiner::isNearColumn(Index cell) const
{
    const CellLattice& lattice = _map.getLattice();
    for (const auto side : CellLattice::LEVEL_SIDES)
    {
        const bool isAlongX = CellLattice::isAlongX(side);
        Index next = cell;
        for (int length = 1; length <= PartSizes::LONGEST && next != CellLattice::NONE;
             ++length, next = lattice.getNeighbor(next, side))
        {
            if (!PartSizes::join(lattice.getColor(cell), lattice.getColor(next))) break;
            const Index before = lattice.getNeighbor(next, isAlongX ? CellLattice::SOUTH : CellLattice::WEST);
            const Index behind = lattice.getNeighbor(next, isAlongX ? CellLattice::NORTH : CellLattice::EAST);
            for (const Index near : {next, before, behind})
                if (near != CellLattice::NONE && lattice.isInColumn(near)) return true;
        }
    }
    return false;
}

void BridgeJoiner::layAll(const std::vector<PartCut::Piece>& pieces, const LayoutRegion& region)
{
    for (const PartCut::Piece& piece : pieces)
        _map.lay(piece.anchor, piece.shape);
    if (!pieces.empty()) noteContacts(pieces.front().anchor);
    for (const PartCut::Piece& piece : pieces)
        merge(piece.anchor, region);
}

/** Lay one part instead of a part and those beside it, where there is such a part. */
void BridgeJoiner::merge(Index anchor, const LayoutRegion& region)
{
    if (!_map.isAnchor(anchor)) return; // merged before
    for (const auto side : CellLattice::LEVEL_SIDES)
    {
        const Index other = findAligned(anchor, side);
        if (other == CellLattice::NONE || !region.isActive(other)) continue;
        PartShape whole = _map.getShape(anchor);
        const bool isAlongX = CellLattice::isAlongX(side);
        const int length =
            isAlongX ? whole.width + _map.getShape(other).width : whole.depth + _map.getShape(other).depth;
        (isAlongX ? whole.width : whole.depth) = static_cast<std::uint8_t>(length);
        const auto color = PartSizes::join(_map.getColor(anchor), _map.getColor(other));
        if (length > PartSizes::LONGEST || !color || !_sizes.isMade(whole, *color)) continue;
        anchor = std::min(anchor, other);
        _map.lay(anchor, whole);
        noteContacts(anchor);
    }
}

/** The part on one side of a part that forms a box with it; NONE if there is none. */
BridgeJoiner::Index BridgeJoiner::findAligned(Index anchor, CellLattice::Side side) const
{
    const CellLattice& lattice = _map.getLattice();
    const PartShape& shape = _map.getShape(anchor);
    const bool isAlongX = CellLattice::isAlongX(side);
    const bool isAhead = side == CellLattice::EAST || side == CellLattice::NORTH;
    const int length = isAlongX ? shape.width : shape.depth;
    const Index beside = lattice.move(anchor, side, isAhead ? length : 1);
    if (beside == CellLattice::NONE) return CellLattice::NONE;
    const Index other = _map.getAnchor(beside);
    const PartShape& otherShape = _map.getShape(other);
    const bool isAligned = isAlongX ? otherShape.depth == shape.depth && lattice.getY(other) == lattice.getY(anchor)
                                    : otherShape.width == shape.width && lattice.getX(other) == lattice.getX(anchor);
    const bool isLevel = otherShape.height == shape.height && lattice.getZ(other) == lattice.getZ(anchor);
    return isAligned && isLevel ? other : CellLattice::NONE;
}

/** Note that a part connects the parts above and below it. */
void BridgeJoiner::noteContacts(Index anchor)
{
    Index first = CellLattice::NONE;
    _map.visitPart(anchor,
                   [&](Index cell)
                   {
                       if (!_map.getLattice().isInColumn(cell)) return;
                       if (first == CellLattice::NONE) first = cell;
                       _components.join(first, cell);
                   });
}

} // namespace osgLego
