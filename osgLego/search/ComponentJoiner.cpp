#include <osgLego/search/ComponentJoiner.h>

#include <osgLego/search/LayoutCosts.h>

#include <array>

namespace osgLego
{

ComponentJoiner::ComponentJoiner(PartMap& map, const PartSizes& sizes) : _map(map), _window(map, sizes) {}

/** Pairs of neighbouring cells that are in different components and that one part may cover. */
ComponentJoiner::Pairs ComponentJoiner::findPairs(const std::vector<bool>& isActive)
{
    const CellLattice& lattice = _map.getLattice();
    Pairs pairs;
    for (Index cell = 0; cell < lattice.getNumCells(); ++cell)
    {
        if (!isActive.empty() && !isActive[static_cast<std::size_t>(cell)]) continue;
        for (const auto side : {CellLattice::EAST, CellLattice::NORTH})
        {
            const Index other = lattice.getNeighbor(cell, side);
            if (other == CellLattice::NONE || _map.getAnchor(cell) == _map.getAnchor(other)) continue;
            if (_components.find(cell) == _components.find(other)) continue;
            if (PartSizes::join(lattice.getColor(cell), lattice.getColor(other))) pairs.emplace_back(cell, other);
        }
    }
    return pairs;
}

bool ComponentJoiner::join(Index cell, Index other, const Limits& limits, const std::vector<bool>& isActive,
                           LayoutRandom& random)
{
    constexpr int FEWEST_PARTS = 2;
    constexpr int MOST_PARTS = 12;
    const CellLattice& lattice = _map.getLattice();
    const LayoutRegion everything{0, lattice.getNumLayers(), 0, lattice.getProblem().size.y, 0, 0, nullptr, &isActive};
    for (int attempt = 0; attempt < limits.perPair && _numAttempts < limits.total; ++attempt)
    {
        ++_numAttempts;
        const int numParts = FEWEST_PARTS + static_cast<int>(random.below(MOST_PARTS - FEWEST_PARTS + 1));
        if (_window.join(cell, other, numParts, everything, LayoutCosts::COMPONENT, random)) return true;
    }
    return false;
}

bool ComponentJoiner::joinAll(const Limits& limits, const std::vector<bool>& isActive, LayoutRandom& random,
                              const std::function<bool()>& isCancelled)
{
    _numAttempts = 0;
    for (int numAttempts = -1; numAttempts < _numAttempts;)
    {
        numAttempts = _numAttempts;
        _map.findComponents(_components);
        Pairs pairs = findPairs(isActive);
        random.shuffle(pairs);
        for (const auto& [cell, other] : pairs)
        {
            if (isCancelled && isCancelled()) return false;
            // An earlier pair may have joined these components already.
            if (_components.find(cell) == _components.find(other)) continue;
            const Index anchor = _map.getAnchor(cell);
            const Index otherAnchor = _map.getAnchor(other);
            // If each part touches no other part above or below, the cost of parts alone makes window search merge
            // them.
            if (anchor == otherAnchor || (_map.isAlone(anchor) && _map.isAlone(otherAnchor))) continue;
            if (join(cell, other, limits, isActive, random)) _components.join(cell, other);
        }
    }
    return true;
}

} // namespace osgLego
