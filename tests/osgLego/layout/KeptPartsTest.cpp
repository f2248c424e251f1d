#include "LaidModel.h"

#include <osgLego/layout/KeptParts.h>

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
