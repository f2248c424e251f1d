#include <osgLego/model/CellExposure.h>

#include "../layout/LaidModel.h"

#include <osgLego/GridLimits.h>

#include <HeapSize.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** A closed box of 7 x 7 x 7 cells, one cell thick, in the middle of 11 x 11 x 11. */
bool isOfBox(int x, int y, int z)
{
    const auto isWithin = [](int value, int lower, int upper) { return value >= lower && value <= upper; };
    const bool isOutside = !isWithin(x, 2, 8) || !isWithin(y, 2, 8) || !isWithin(z, 2, 8);
    const bool isInside = isWithin(x, 3, 7) && isWithin(y, 3, 7) && isWithin(z, 3, 7);
    return !isOutside && !isInside;
}

LayoutProblem makeBox(const glm::ivec3& hole = {-1, -1, -1})
{
    return makeCells({11, 11, 11},
                     [&](int x, int y, int z) { return isOfBox(x, y, z) && glm::ivec3(x, y, z) != hole ? 0 : -1; });
}

TEST(CellExposure, OfCellsInAClosedBoxIsZero)
{
    const LayoutProblem box = makeBox();
    const CellExposure exposure(box);
    for (int z = 3; z <= 7; ++z)
        for (int y = 3; y <= 7; ++y)
            for (int x = 3; x <= 7; ++x)
                EXPECT_EQ(exposure.get({x, y, z}), 0.0);
}

TEST(CellExposure, IsTheShareOfOpenDirectionsAndLessBelow)
{
    // 8 directions sideways, 9 upwards, and 9 downwards that count a quarter.
    constexpr double ALL = 17.0 + 9.0 / 4.0;
    const LayoutProblem box = makeBox();
    const CellExposure exposure(box);
    EXPECT_DOUBLE_EQ(exposure.get({0, 5, 10}), 1.0 - 0.75 / ALL) << "an edge of the box is in three directions";
    EXPECT_DOUBLE_EQ(exposure.get({5, 5, 9}), 17.0 / ALL) << "above the middle of the box";
    EXPECT_DOUBLE_EQ(exposure.get({5, 5, 1}), (8.0 + 9.0 / 4.0) / ALL) << "below it";
}

TEST(CellExposure, OfACellBehindAHoleIsThatOfOneDirection)
{
    const LayoutProblem box = makeBox({5, 5, 8});
    EXPECT_DOUBLE_EQ(CellExposure(box).get({5, 5, 4}), 1.0 / (17.0 + 9.0 / 4.0));
}

TEST(CellExposure, MemoryFollowsTheCellsNotTheSizeOfTheLayout)
{
    LayoutProblem problem;
    problem.size = GridLimits::getLargest(2);
    problem.cells.resize(1);
    const std::size_t before = test::getHeapSize();
    const CellExposure exposure(problem);
    EXPECT_LT(test::getHeapSize() - before, test::HEAP_OF_FEW_BRICKS);
    EXPECT_DOUBLE_EQ(exposure.get({problem.size.x - 1, 0, 0}), 1.0 - 1.0 / (17.0 + 9.0 / 4.0))
        << "the cell is in one direction, sideways";
}

} // namespace

} // namespace osgLego
