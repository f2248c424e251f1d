#include <osgLego/search/LayoutWindow.h>

#include <osgLego/search/LayoutCosts.h>

#include <array>
#include <cstddef>

namespace osgLego
{

LayoutWindow::LayoutWindow(PartMap& map, const PartSizes& sizes) :
    _map(map), _hasBricks(sizes.getHeights().size() > 1), _window(map, sizes), _connections(map),
    _seen(static_cast<std::size_t>(map.getLattice().getNumCells()))
{
}

bool LayoutWindow::improve(Index anchor, int numParts, int seamCost, const LayoutRegion& region, int maximumNodes,
                           LayoutRandom& random)
{
    gather({&anchor, 1}, numParts, region, _hasBricks, random);
    _window.build(random, seamCost);
    if (!_cover.findCheaper(_window.getParts(), _window.getCost(), maximumNodes, _chosen)) return false;
    _connections.start(_window, region);
    if (!_connections.keepsConnections(_chosen)) return false;
    apply();
    return true;
}

bool LayoutWindow::join(Index cell, Index other, int numParts, const LayoutRegion& region, int maximumCost,
                        LayoutRandom& random)
{
    constexpr int MAXIMUM_NODES = 2000;
    const std::array anchors{_map.getAnchor(cell), _map.getAnchor(other)};
    gather(anchors, numParts, region, true, random);
    _window.build(random, LayoutCosts::HALF_SEAM);
    const int cost = _window.getCost();
    _window.keepTogether(cell, other);
    if (!_cover.findCheaper(_window.getParts(), cost + maximumCost, MAXIMUM_NODES, _chosen)) return false;
    _connections.start(_window, region);
    if (!_connections.joinsComponents(_chosen)) return false;
    apply();
    return true;
}

/** Add the first parts to the window, then repeatedly a random neighbour of its parts. */
void LayoutWindow::gather(std::span<const Index> first, int numParts, const LayoutRegion& region, bool hasLayers,
                          LayoutRandom& random)
{
    _window.clear();
    _frontier.clear();
    ++_numGathered;
    for (const Index anchor : first)
        _seen[static_cast<std::size_t>(anchor)] = _numGathered;
    for (const Index anchor : first)
        if (_window.addPart(anchor)) addFrontier(anchor, region, hasLayers);
    while (!_frontier.empty() && static_cast<int>(_window.getAnchors().size()) < numParts)
    {
        const std::size_t i = random.below(_frontier.size());
        const Index next = _frontier[i];
        _frontier[i] = _frontier.back();
        _frontier.pop_back();
        if (_window.addPart(next)) addFrontier(next, region, hasLayers);
    }
}

/** Record neighbours of a part: those in its layer whose cells one part could cover together with its own, and, if
 * `hasLayers`, those above and below. */
void LayoutWindow::addFrontier(Index anchor, const LayoutRegion& region, bool hasLayers)
{
    const CellLattice& lattice = _map.getLattice();
    const std::uint8_t numSides = hasLayers ? 6 : 4;
    _map.visitPart(anchor,
                   [&](Index cell)
                   {
                       for (std::uint8_t side = 0; side < numSides; ++side)
                       {
                           const Index other = lattice.getNeighbor(cell, static_cast<CellLattice::Side>(side));
                           if (other == CellLattice::NONE || _map.getAnchor(other) == anchor) continue;
                           if (side < 4 && !PartSizes::join(lattice.getColor(cell), lattice.getColor(other))) continue;
                           const Index neighbor = _map.getAnchor(other);
                           std::uint32_t& seen = _seen[static_cast<std::size_t>(neighbor)];
                           if (seen == _numGathered) continue;
                           seen = _numGathered;
                           if (region.contains(_map, neighbor) && region.isActive(neighbor))
                               _frontier.push_back(neighbor);
                       }
                   });
}

void LayoutWindow::apply()
{
    for (const int part : _chosen)
        _map.lay(_window.getCells()[static_cast<std::size_t>(_window.getFirstCell(part))],
                 _window.getParts().parts[static_cast<std::size_t>(part)].shape);
}

} // namespace osgLego
