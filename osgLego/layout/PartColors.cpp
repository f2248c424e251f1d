#include <osgLego/layout/PartColors.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace osgLego
{

namespace
{

using Index = CellLattice::Index;
using Colors = std::vector<std::uint16_t>;

/** Call visit(anchor) for each cell beside a part, with the anchor of its part. */
template <typename Visit>
void visitNeighbors(const PartMap& map, Index anchor, Visit visit)
{
    const CellLattice& lattice = map.getLattice();
    map.visitPart(anchor,
                  [&](Index cell)
                  {
                      for (std::uint8_t side = 0; side < 6; ++side)
                      {
                          const Index other = lattice.getNeighbor(cell, static_cast<CellLattice::Side>(side));
                          if (other != CellLattice::NONE && map.getAnchor(other) != anchor) visit(map.getAnchor(other));
                      }
                  });
}

/** The commonest colour of the cells around a part in which it exists, or ANY_COLOR. */
std::uint16_t findCommonest(const PartMap& map, const PartSizes& sizes, const Colors& colors, Index anchor)
{
    std::map<std::uint16_t, int> counts;
    visitNeighbors(map, anchor,
                   [&](Index neighbor)
                   {
                       const std::uint16_t color = colors[static_cast<std::size_t>(neighbor)];
                       if (color != LayoutCell::ANY_COLOR) ++counts[color];
                   });
    std::pair<int, std::uint16_t> best{0, LayoutCell::ANY_COLOR};
    for (const auto& [color, count] : counts)
        if (count > best.first && sizes.isMade(map.getShape(anchor), color)) best = {count, color};
    return best.second;
}

/** The first colour in which a part exists; colour 0 if there is none. */
std::uint16_t findFirst(const PartMap& map, const PartSizes& sizes, Index anchor)
{
    const auto numColors = static_cast<std::uint16_t>(map.getLattice().getProblem().colors.size());
    for (std::uint16_t color = 0; color < numColors; ++color)
        if (sizes.isMade(map.getShape(anchor), color)) return color;
    return 0;
}

using Anchors = std::vector<Index>;

/** The parts without a colour beside some parts. */
Anchors findOpenNeighbors(const PartMap& map, const Colors& colors, const Anchors& anchors)
{
    Anchors open;
    for (const Index anchor : anchors)
        visitNeighbors(map, anchor,
                       [&](Index neighbor)
                       {
                           if (colors[static_cast<std::size_t>(neighbor)] == LayoutCell::ANY_COLOR)
                               open.push_back(neighbor);
                       });
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
    return open;
}

/** Spread the colours of neighbours to parts without a colour, and from there on, until no neighbour suits. In each
 * round, colours spread by one part in all directions at once. */
void spread(const PartMap& map, const PartSizes& sizes, Anchors open, Colors& colors)
{
    while (!open.empty())
    {
        Anchors colored;
        std::vector<std::uint16_t> chosen;
        for (const Index anchor : open)
        {
            const std::uint16_t color = findCommonest(map, sizes, colors, anchor);
            if (color == LayoutCell::ANY_COLOR) continue;
            colored.push_back(anchor);
            chosen.push_back(color);
        }
        for (std::size_t i = 0; i < colored.size(); ++i)
            colors[static_cast<std::size_t>(colored[i])] = chosen[i];
        // Only a part beside a new colour can get one in the next round.
        open = findOpenNeighbors(map, colors, colored);
    }
}

} // namespace

Colors choosePartColors(const PartMap& map, const PartSizes& sizes)
{
    Colors colors(static_cast<std::size_t>(map.getLattice().getNumCells()), LayoutCell::ANY_COLOR);
    Anchors open;
    for (Index cell = 0; cell < map.getLattice().getNumCells(); ++cell)
    {
        if (!map.isAnchor(cell)) continue;
        std::uint16_t& color = colors[static_cast<std::size_t>(cell)];
        color = map.getColor(cell);
        if (color == LayoutCell::ANY_COLOR) open.push_back(cell);
    }
    // Colours spread from the surface inwards, and then from parts that no neighbour suits, which get the first colour
    // that does.
    spread(map, sizes, open, colors);
    for (const Index anchor : open)
    {
        std::uint16_t& color = colors[static_cast<std::size_t>(anchor)];
        if (color != LayoutCell::ANY_COLOR) continue;
        color = findFirst(map, sizes, anchor);
        spread(map, sizes, findOpenNeighbors(map, colors, {anchor}), colors);
    }
    return colors;
}

LaidParts collectParts(const PartMap& map, const PartSizes& sizes)
{
    const CellLattice& lattice = map.getLattice();
    const Colors colors = choosePartColors(map, sizes);
    LaidParts parts;
    for (Index cell = 0; cell < lattice.getNumCells(); ++cell)
    {
        if (!map.isAnchor(cell)) continue;
        const auto index = static_cast<std::size_t>(cell);
        const PartShape& shape = map.getShape(cell);
        parts.push_back(
            {lattice.getProblem().cells[index].place, {shape.width, shape.depth, shape.height}, colors[index]});
    }
    return parts;
}

} // namespace osgLego
