#include <osgLego/layout/PartColors.h>

#include <cstddef>
#include <map>
#include <utility>

namespace osgLego
{

namespace
{

using Index = CellLattice::Index;
using Colors = std::vector<std::uint16_t>;

/** The commonest colour of the cells around a part in which it exists, or ANY_COLOR. */
std::uint16_t findCommonest(const PartMap& map, const PartSizes& sizes, const Colors& colors, Index anchor)
{
    const CellLattice& lattice = map.getLattice();
    std::map<std::uint16_t, int> counts;
    map.visitPart(anchor,
                  [&](Index cell)
                  {
                      for (std::uint8_t side = 0; side < 6; ++side)
                      {
                          const Index other = lattice.getNeighbor(cell, static_cast<CellLattice::Side>(side));
                          if (other == CellLattice::NONE || map.getAnchor(other) == anchor) continue;
                          const std::uint16_t color = colors[static_cast<std::size_t>(map.getAnchor(other))];
                          if (color != LayoutCell::ANY_COLOR) ++counts[color];
                      }
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

} // namespace

Colors choosePartColors(const PartMap& map, const PartSizes& sizes)
{
    Colors colors(static_cast<std::size_t>(map.getLattice().getNumCells()), LayoutCell::ANY_COLOR);
    std::vector<Index> open;
    for (Index cell = 0; cell < map.getLattice().getNumCells(); ++cell)
    {
        if (!map.isAnchor(cell)) continue;
        colors[static_cast<std::size_t>(cell)] = map.getColor(cell);
        if (colors[static_cast<std::size_t>(cell)] == LayoutCell::ANY_COLOR) open.push_back(cell);
    }
    // Colours spread from the surface inwards. The few parts that no neighbour suits get the first colour that does.
    while (!open.empty())
    {
        std::vector<Index> rest;
        Colors next = colors;
        for (const Index anchor : open)
        {
            std::uint16_t& color = next[static_cast<std::size_t>(anchor)];
            color = findCommonest(map, sizes, colors, anchor);
            if (color == LayoutCell::ANY_COLOR) rest.push_back(anchor);
        }
        colors.swap(next);
        if (rest.size() == open.size())
        {
            const Index anchor = rest.front();
            colors[static_cast<std::size_t>(anchor)] = findFirst(map, sizes, anchor);
            rest.erase(rest.begin());
        }
        open.swap(rest);
    }
    return colors;
}

} // namespace osgLego
