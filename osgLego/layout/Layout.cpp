#include <osgLego/layout/Layout.h>

#include <osgLego/layout/ComponentJoiner.h>
#include <osgLego/layout/GreedyLayout.h>
#include <osgLego/layout/WindowSearch.h>

#include <cstdlib>

namespace osgLego
{

LaidParts layOut(const LayoutProblem& problem, const LayoutOptions& options, const LaidParts&)
{
    const CellLattice lattice(problem);
    const PartSizes sizes(problem);
    PartMap map(lattice);
    layGreedily(map, sizes);
    LayoutRandom random(options.seed);
    ComponentJoiner joiner(map, sizes);
    const int att = getenv("ATT") ? atoi(getenv("ATT")) : 4;
    if (!joiner.joinAll(att, random, options.isCancelled)) return {};
    WindowSearch search(map, sizes, options);
    const int rounds = getenv("ROUNDS") ? atoi(getenv("ROUNDS")) : 10;
    const int nodes = getenv("NODES") ? atoi(getenv("NODES")) : 300;
    for (int round = 0; round < rounds; ++round)
        if (!search.runRound(1.0, nodes)) return {};
    if (!joiner.joinAll(att, random, options.isCancelled)) return {};
    LaidParts parts;
    for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
        if (map.isAnchor(cell))
        {
            const PartShape& shape = map.getShape(cell);
            const std::uint16_t color = map.getColor(cell);
            parts.push_back({problem.cells[static_cast<std::size_t>(cell)].place,
                             {shape.width, shape.depth, shape.height},
                             color == LayoutCell::ANY_COLOR ? std::uint16_t{0} : color});
        }
    return parts;
}

} // namespace osgLego
