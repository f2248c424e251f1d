#include <osgLego/model/HiddenCells.h>

#include "../layout/LaidModel.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(HiddenCells, AreInsideAndWithinReach)
{
    // A closed box of 9 cells a side. Its first part is in a corner at the bottom.
    const LayoutProblem problem = makeCells({9, 9, 9},
                                            [](int x, int y, int z) {
                                                return std::min({x, y, z, 8 - x, 8 - y, 8 - z}) == 0 ? 0 : -1;
                                            });
    const LaidParts parts{{{0, 0, 0}, {2, 2, 1}}};
    EXPECT_EQ(findHiddenCells(problem, parts, {0}, 1).size(), 4u) << "2 x 2 x 1 cells beside the walls";
    const std::vector<LayoutCell> cells = findHiddenCells(problem, parts, {0}, 2);
    EXPECT_EQ(cells.size(), 18u) << "3 x 3 x 2 cells";
    for (const LayoutCell& cell : cells)
    {
        EXPECT_EQ(cell.color, LayoutCell::ANY_COLOR);
        EXPECT_GE(*std::min_element(cell.place.begin(), cell.place.end()), 1);
    }
    EXPECT_TRUE(findHiddenCells(problem, parts, {}, 2).empty());
}

TEST(HiddenCells, AreNoneOutside)
{
    const LayoutProblem problem = makeCells({9, 9, 9}, [](int, int, int z) { return z == 0 ? 0 : -1; });
    EXPECT_TRUE(findHiddenCells(problem, {{{4, 4, 0}}}, {0}, 3).empty());
}

} // namespace

} // namespace osgLego
