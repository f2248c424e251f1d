#include <osgLego/layout/PartColors.h>

#include "LaidModel.h"

#include <Layouts.h>

#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Index = CellLattice::Index;
using Colors = std::vector<std::uint16_t>;

constexpr std::uint16_t ONLY_1X1 = 1;
constexpr std::uint16_t ONLY_1X2 = 2;
constexpr std::uint16_t ANY = LayoutCell::ANY_COLOR;

/** For each cell beside a part, the part of that cell; finds them by comparing all cells. */
std::vector<Index> findNeighbors(const PartMap& map, Index anchor)
{
    const CellLattice& lattice = map.getLattice();
    std::vector<Index> neighbors;
    for (Index cell = 0; cell < lattice.getNumCells(); ++cell)
        for (std::uint8_t side = 0; side < 6 && map.getAnchor(cell) == anchor; ++side)
        {
            const Index other = lattice.getNeighbor(cell, static_cast<CellLattice::Side>(side));
            if (other != CellLattice::NONE && map.getAnchor(other) != anchor) neighbors.push_back(map.getAnchor(other));
        }
    return neighbors;
}

/** Of the colours in which a part is made, the most frequent one among the cells beside it; of equally frequent
 * colours, the one with the lowest index. */
std::uint16_t findCommonest(const PartMap& map, const PartSizes& sizes, const Colors& colors, Index anchor)
{
    std::map<std::uint16_t, int> counts;
    for (const Index neighbor : findNeighbors(map, anchor))
        ++counts[colors[static_cast<std::size_t>(neighbor)]];
    std::uint16_t best = ANY;
    for (const auto& [color, count] : counts)
        if (color != ANY && sizes.isMade(map.getShape(anchor), color) && (best == ANY || count > counts[best]))
            best = color;
    return best;
}

/** Colours by rounds that look at every part; in a round without progress, one part gets the first colour in which it
 * is made. */
Colors chooseByRounds(const PartMap& map, const PartSizes& sizes)
{
    const auto numCells = static_cast<std::size_t>(map.getLattice().getNumCells());
    const auto numColors = map.getLattice().getProblem().colors.size();
    Colors colors(numCells, ANY);
    for (std::size_t cell = 0; cell < numCells; ++cell)
        if (map.isAnchor(static_cast<Index>(cell))) colors[cell] = map.getColor(static_cast<Index>(cell));
    for (;;)
    {
        const Colors before = colors;
        std::vector<std::size_t> rest;
        for (std::size_t cell = 0; cell < numCells; ++cell)
        {
            if (!map.isAnchor(static_cast<Index>(cell)) || before[cell] != ANY) continue;
            colors[cell] = findCommonest(map, sizes, before, static_cast<Index>(cell));
            if (colors[cell] == ANY) rest.push_back(cell);
        }
        if (rest.empty()) return colors;
        if (colors != before) continue;
        std::uint16_t first = 0;
        while (first < numColors && !sizes.isMade(map.getShape(static_cast<Index>(rest.front())), first))
            ++first;
        colors[rest.front()] = first < numColors ? first : std::uint16_t(0);
    }
}

/** Cover some pairs of cells by one part, where their colours allow it, and each other cell by a part of one cell. */
void layPairs(PartMap& map, std::mt19937& engine)
{
    const CellLattice& lattice = map.getLattice();
    for (Index cell = 0; cell < lattice.getNumCells(); ++cell)
    {
        if (map.getAnchor(cell) != CellLattice::NONE) continue;
        const bool isAlongX = engine() % 2 == 0;
        const Index other = lattice.getNeighbor(cell, isAlongX ? CellLattice::EAST : CellLattice::NORTH);
        const bool isPair = other != CellLattice::NONE && map.getAnchor(other) == CellLattice::NONE &&
                            PartSizes::join(lattice.getColor(cell), lattice.getColor(other)) && engine() % 2 == 0;
        PartShape shape;
        if (isPair) (isAlongX ? shape.width : shape.depth) = 2;
        map.lay(cell, shape);
    }
}

TEST(PartColors, SpreadInRoundsFromNeighborsAndFromPartsThatNoneSuits)
{
    std::mt19937 engine(7);
    for (unsigned int seed = 0; seed < 200; ++seed)
    {
        LayoutProblem problem = createRandomProblem({7, 5, 3}, seed % 2 == 0 ? "abc*****." : "a**.", seed);
        problem.colors = {{ONLY_1X1, 0}, {ONLY_1X2, 0}, {ONLY_1X1 | ONLY_1X2, 0}};
        const CellLattice lattice(problem);
        const PartSizes sizes(problem);
        PartMap map(lattice);
        layPairs(map, engine);
        const Colors colors = choosePartColors(map, sizes);
        const Colors expected = chooseByRounds(map, sizes);
        for (Index cell = 0; cell < lattice.getNumCells(); ++cell)
        {
            if (!map.isAnchor(cell)) continue;
            ASSERT_EQ(colors[static_cast<std::size_t>(cell)], expected[static_cast<std::size_t>(cell)])
                << "seed " << seed << ", cell " << cell;
        }
    }
}

TEST(PartColors, APartThatNoNeighborSuitsGetsTheFirstColorInWhichItIsMadeAndSpreadsIt)
{
    const LayoutProblem problem = makeCells({5, 1, 1}, [](int x, int, int) { return x == 0 ? 0 : ANY; },
                                            {{ONLY_1X1, 0}, {0, 0}, {ONLY_1X1 | ONLY_1X2, 0}});
    const CellLattice lattice(problem);
    PartMap map(lattice);
    map.lay(0, {});
    map.lay(1, {2, 1, 1});
    map.lay(3, {2, 1, 1});
    const Colors colors = choosePartColors(map, PartSizes(problem));
    EXPECT_EQ(colors[0], 0);
    EXPECT_EQ(colors[1], 2);
    EXPECT_EQ(colors[3], 2);
}

// Each pocket needs a round. If the work grew with the square of their number, the test would take an hour.
TEST(PartColors, AHundredThousandPocketsThatNoNeighborSuitsGetAColor)
{
    constexpr int NUM_POCKETS = 20000; // in each of five rows
    const LayoutProblem problem =
        makeCells({3 * NUM_POCKETS, 9, 1}, [](int x, int y, int) { return y % 2 == 1   ? -1
                                                                          : x % 3 == 0 ? 0
                                                                                       : ANY; },
                  {{ONLY_1X1, 0}, {ONLY_1X2, 0}});
    const CellLattice lattice(problem);
    PartMap map(lattice);
    for (Index cell = 0; cell < lattice.getNumCells(); cell += 3)
    {
        map.lay(cell, {});
        map.lay(cell + 1, {2, 1, 1});
    }
    const Colors colors = choosePartColors(map, PartSizes(problem));
    int numPockets = 0;
    for (std::size_t cell = 1; cell < colors.size(); cell += 3)
        numPockets += colors[cell] == 1 ? 1 : 0;
    EXPECT_EQ(numPockets, 5 * NUM_POCKETS);
}

} // namespace

} // namespace osgLego
