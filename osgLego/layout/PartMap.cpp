#include <osgLego/layout/PartMap.h>

namespace osgLego
{

PartMap::PartMap(const CellLattice& lattice) :
    _lattice(lattice), _anchors(static_cast<std::size_t>(lattice.getNumCells()), CellLattice::NONE),
    _shapes(_anchors.size())
{
}

std::uint16_t PartMap::getColor(Index anchor) const
{
    std::uint16_t color = LayoutCell::ANY_COLOR;
    visitPart(anchor,
              [&](Index cell)
              {
                  if (color == LayoutCell::ANY_COLOR) color = _lattice.getColor(cell);
              });
    return color;
}

PartMap::Index PartMap::countParts() const
{
    Index count = 0;
    for (Index cell = 0; cell < _lattice.getNumCells(); ++cell)
        count += isAnchor(cell) ? 1 : 0;
    return count;
}

void PartMap::findComponents(UnionFind& components) const
{
    components.reset(static_cast<std::size_t>(_lattice.getNumCells()));
    for (Index cell = 0; cell < _lattice.getNumCells(); ++cell)
    {
        components.join(cell, getAnchor(cell));
        const Index above = _lattice.getNeighbor(cell, CellLattice::ABOVE);
        if (above != CellLattice::NONE) components.join(cell, above);
    }
}

bool PartMap::isAlone(Index anchor) const
{
    bool isAlone = true;
    visitPart(anchor,
              [&](Index cell)
              {
                  for (const auto side : {CellLattice::ABOVE, CellLattice::BELOW})
                  {
                      const Index other = _lattice.getNeighbor(cell, side);
                      isAlone &= other == CellLattice::NONE || getAnchor(other) == anchor;
                  }
              });
    return isAlone;
}

void PartMap::swap(PartMap& other)
{
    _anchors.swap(other._anchors);
    _shapes.swap(other._shapes);
}

void PartMap::lay(Index anchor, const PartShape& shape)
{
    _shapes[static_cast<std::size_t>(anchor)] = shape;
    visitCells(anchor, shape, [&](Index cell) { _anchors[static_cast<std::size_t>(cell)] = anchor; });
}

void PartMap::remove(Index anchor)
{
    visitPart(anchor, [&](Index cell) { _anchors[static_cast<std::size_t>(cell)] = CellLattice::NONE; });
}

} // namespace osgLego
