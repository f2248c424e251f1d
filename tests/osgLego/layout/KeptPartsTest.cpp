#include "LaidModel.h"

#include <osgLego/layout/KeptParts.h>

#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

const LaidPart BRICK{{1, 1, 0}, {4, 2, 3}, 0};

/** A block of plates, as high as a brick. */
LayoutProblem makeBlock(const std::function<int(int, int, int)>& getColor)
{
    LayoutProblem problem = makeCells({6, 4, 3}, getColor, std::vector<LayoutColor>(2));
    problem.isOfPlates = true;
    return problem;
}

bool keepsTheBrick(const LayoutProblem& problem)
{
    const CellLattice lattice(problem);
    PartMap map(lattice);
    keepParts(map, PartSizes(problem), {BRICK});
    return map.countParts() == 1;
}

} // namespace

TEST(KeptParts, KeepABrickWhoseCellsAllExistInItsColor)
{
    EXPECT_TRUE(keepsTheBrick(makeBlock([](int, int, int) { return 0; })));
    EXPECT_TRUE(
        keepsTheBrick(makeBlock([](int, int, int z) { return z == 1 ? static_cast<int>(LayoutCell::ANY_COLOR) : 0; })));
    EXPECT_FALSE(keepsTheBrick(makeBlock([](int, int, int) { return 1; })));
}

TEST(KeptParts, DropABrickThatWasNeverMadeInItsColor)
{
    LayoutProblem problem = makeBlock([](int, int, int) { return 0; });
    problem.colors[0].bricks = 0;
    EXPECT_FALSE(keepsTheBrick(problem));
}

TEST(KeptParts, ChangedCellsAreThoseWithinTheDistanceOfAnUncoveredOne)
{
    // A cross of cells, of which only the one in the middle is uncovered.
    constexpr int CENTER = 5;
    const auto isOnAxes = [](int x, int y, int z)
    { return (x == CENTER ? 0 : 1) + (y == CENTER ? 0 : 1) + (z == CENTER ? 0 : 1) <= 1; };
    const LayoutProblem problem = makeCells(
        {11, 11, 11}, [&](int x, int y, int z) { return isOnAxes(x, y, z) ? (x + y + z) % 2 : -1; },
        std::vector<LayoutColor>(2));
    const CellLattice lattice(problem);
    PartMap map(lattice);
    const auto getDistance = [&](CellLattice::Index cell)
    {
        return std::abs(lattice.getX(cell) - CENTER) + std::abs(lattice.getY(cell) - CENTER) +
               std::abs(lattice.getZ(cell) - CENTER);
    };
    for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
        if (getDistance(cell) > 0) map.lay(cell, {});
    const std::vector<bool> isChanged = findChangedCells(map, 3);
    for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
        EXPECT_EQ(isChanged[static_cast<std::size_t>(cell)], getDistance(cell) <= 3) << cell;
}

TEST(KeptParts, DropABrickOfWhichAnyCellVanishesOrChangesItsColor)
{
    for (int z = 0; z < 3; ++z)
        for (int y = 1; y < 3; ++y)
            for (int x = 1; x < 5; ++x)
                for (const int color : {-1, 1})
                {
                    const auto getColor = [&](int cellX, int cellY, int cellZ)
                    { return cellX == x && cellY == y && cellZ == z ? color : 0; };
                    EXPECT_FALSE(keepsTheBrick(makeBlock(getColor))) << x << ' ' << y << ' ' << z << ' ' << color;
                }
}

} // namespace osgLego
