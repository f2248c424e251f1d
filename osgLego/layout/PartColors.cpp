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

/** For each cell beside a part, call visit(anchor) with the anchor of the neighbouring part. */
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

/** Of the colours of adjacent cells, the most frequent one in which the part exists; ANY_COLOR if there is none. */
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

/** The parts without a colour that are beside any of the given parts. */
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

/** Give parts without a colour the colours of their neighbours, until no part can take one. In each round, colours
 * spread by one part in all directions. */
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
        // In the next round, only neighbours of parts that have just been coloured can get a colour.
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
    // Colours spread from the surface inwards. A part that exists in no neighbour's colour gets the first colour in
    // which it exists, and colours spread from there.
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
