#include <osgLego/layout/CellFill.h>

#include <Meshes.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include <glm/common.hpp>

namespace osgLego::test
{

namespace
{

using Cell = std::array<int, 3>;

BrickGrid gridOf(const glm::ivec3& size)
{
    BrickGrid grid;
    grid.dimensions = size;
    return grid;
}

template <typename IsCovered>
osg::ref_ptr<const BrickModel> createModel(const glm::ivec3& size, IsCovered isCovered)
{
    std::vector<Brick> bricks;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (isCovered(x, y, z))
                    bricks.push_back(
                        {{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(z)},
                         {200, 10, 20}});
    return BrickModel::create(gridOf(size), bricks);
}

FilledCells fill(const BrickModel& model, Fill fill, unsigned int shell = 2)
{
    FilledCells cells;
    std::string error;
    EXPECT_TRUE(fillCells(model, fill, shell, cells, error)) << error;
    EXPECT_EQ(cells.isInterior.size(), cells.bricks.size());
    EXPECT_EQ(static_cast<std::size_t>(std::count(cells.isInterior.begin(), cells.isInterior.end(), true)),
              cells.numInterior);
    return cells;
}

/** The walls of a box of the given size, one cell thick. */
osg::ref_ptr<const BrickModel> createBox(const glm::ivec3& size)
{
    return createModel(size, [&](int x, int y, int z)
                       { return x * y * z == 0 || x == size.x - 1 || y == size.y - 1 || z == size.z - 1; });
}

TEST(CellFill, ASolidBoxHasEveryCellOnceInTheOrderOfTheirNumbers)
{
    const FilledCells cells = fill(*createBox({5, 6, 7}), Fill::SOLID);
    ASSERT_EQ(cells.bricks.size(), 5u * 6u * 7u);
    EXPECT_EQ(cells.numInterior, 3u * 4u * 5u);
    for (std::size_t index = 0; index < cells.bricks.size(); ++index)
    {
        const auto& cell = cells.bricks[index].cell;
        EXPECT_EQ(cell[0] + 5u * (cell[1] + 6u * cell[2]), index);
        EXPECT_EQ(cells.bricks[index].color, (std::array<std::uint8_t, 3>{200, 10, 20}));
        const bool isInside = cell[0] % 4 != 0 && cell[1] % 5 != 0 && cell[2] % 6 != 0;
        EXPECT_EQ(cells.isInterior[index], isInside) << index;
    }
}

TEST(CellFill, AShellIsAsThickAsTheSettingSays)
{
    const osg::ref_ptr<const BrickModel> box = createBox({12, 12, 12});
    EXPECT_EQ(fill(*box, Fill::SURFACE).bricks.size(), box->getBricks().size());
    EXPECT_EQ(fill(*box, Fill::SHELL, 1).numInterior, 0u);
    EXPECT_EQ(fill(*box, Fill::SHELL, 2).bricks.size(), 12u * 12u * 12u - 8u * 8u * 8u);
    EXPECT_EQ(fill(*box, Fill::SHELL, 3).bricks.size(), 12u * 12u * 12u - 6u * 6u * 6u);
    EXPECT_EQ(fill(*box, Fill::SHELL, 1024).bricks.size(), 12u * 12u * 12u);
}

TEST(CellFill, OnlyAShellThatLeavesCellsOutIsHollow)
{
    const osg::ref_ptr<const BrickModel> box = createBox({12, 12, 12});
    EXPECT_FALSE(fill(*box, Fill::SURFACE).isHollow);
    EXPECT_FALSE(fill(*box, Fill::SOLID).isHollow);
    EXPECT_TRUE(fill(*box, Fill::SHELL, 1).isHollow);
    EXPECT_TRUE(fill(*box, Fill::SHELL, 5).isHollow);
    EXPECT_FALSE(fill(*box, Fill::SHELL, 6).isHollow);
}

TEST(CellFill, AHoleInTheWallLetsTheOutsideIn)
{
    const auto createHolly = [](const glm::ivec3& hole)
    {
        return createModel({6, 6, 6}, [&](int x, int y, int z)
                           { return glm::ivec3(x, y, z) != hole && (x % 5 == 0 || y % 5 == 0 || z % 5 == 0); });
    };
    for (const glm::ivec3& hole : {glm::ivec3(0, 3, 3), glm::ivec3(5, 3, 3), glm::ivec3(3, 0, 3), glm::ivec3(3, 5, 3),
                                   glm::ivec3(3, 3, 0), glm::ivec3(3, 3, 5)})
        EXPECT_EQ(fill(*createHolly(hole), Fill::SOLID).numInterior, 0u) << hole.x << hole.y << hole.z;
    // A hole at an edge touches no interior cell side by side.
    EXPECT_EQ(fill(*createHolly({0, 0, 3}), Fill::SOLID).numInterior, 64u);
}

/** The empty cells that a flood fill from outside does not reach, and its distances to the other cells. */
std::set<Cell> findInside(const BrickModel& model)
{
    const glm::ivec3 size = model.getGrid().dimensions;
    std::set<Cell> reached;
    std::vector<glm::ivec3> open{{-1, -1, -1}};
    while (!open.empty())
    {
        const glm::ivec3 cell = open.back();
        open.pop_back();
        const bool isFar = cell != glm::clamp(cell, glm::ivec3(-1), size);
        if (isFar || model.find(cell) || !reached.insert({cell.x, cell.y, cell.z}).second) continue;
        for (int side = 0; side < 6; ++side)
        {
            glm::ivec3 next = cell;
            next[side / 2] += side % 2 == 0 ? 1 : -1;
            open.push_back(next);
        }
    }
    std::set<Cell> inside;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (!model.find({x, y, z}) && !reached.contains({x, y, z})) inside.insert({x, y, z});
    return inside;
}

/** The least number of steps from a cell to one that is empty once the inside is filled. */
int distanceToOutside(const BrickModel& model, const std::set<Cell>& inside, const glm::ivec3& from)
{
    const glm::ivec3 size = model.getGrid().dimensions;
    int least = 1000;
    for (int z = -1; z <= size.z; ++z)
        for (int y = -1; y <= size.y; ++y)
            for (int x = -1; x <= size.x; ++x)
                if (!model.find({x, y, z}) && !inside.contains({x, y, z}))
                    least = std::min(least, std::abs(x - from.x) + std::abs(y - from.y) + std::abs(z - from.z));
    return least;
}

TEST(CellFill, RandomCellsAreFilledAsAFloodCellByCellFillsThem)
{
    std::mt19937 random(3);
    for (int round = 0; round < 40; ++round)
    {
        const glm::ivec3 size(2 + random() % 9, 2 + random() % 9, 2 + random() % 9);
        const osg::ref_ptr<const BrickModel> model =
            createModel(size, [&](int, int, int) { return random() % 100 < 60; });
        const std::set<Cell> inside = findInside(*model);
        for (const unsigned int shell : {1u, 2u, 3u, 1000u})
        {
            std::set<Cell> found;
            const FilledCells cells = fill(*model, Fill::SHELL, shell);
            for (std::size_t index = 0; index < cells.bricks.size(); ++index)
            {
                const auto& cell = cells.bricks[index].cell;
                if (cells.isInterior[index])
                    found.insert({cell[0], cell[1], cell[2]});
                else
                    EXPECT_TRUE(model->find(cells.bricks[index].getCell()));
            }
            std::set<Cell> expected;
            for (const Cell& cell : inside)
                if (distanceToOutside(*model, inside, {cell[0], cell[1], cell[2]}) <= static_cast<int>(shell))
                    expected.insert(cell);
            EXPECT_EQ(found, expected) << "round " << round << ", shell " << shell;
            EXPECT_EQ(cells.bricks.size(), model->getBricks().size() + expected.size());
        }
    }
}

TEST(CellFill, AnEmptyModelAndOneCellHaveNoInterior)
{
    EXPECT_TRUE(fill(*createModel({0, 0, 0}, [](int, int, int) { return false; }), Fill::SOLID).bricks.empty());
    EXPECT_TRUE(fill(*createModel({4, 4, 4}, [](int, int, int) { return false; }), Fill::SOLID).bricks.empty());
    EXPECT_EQ(fill(*createModel({1, 1, 1}, [](int, int, int) { return true; }), Fill::SOLID).numInterior, 0u);
}

TEST(CellFill, TooManyCellsAreRefusedWithTheirNumber)
{
    // Two walls would do, but a box is closed; its walls of 6 * 420^2 cells are quickly made.
    const osg::ref_ptr<const BrickModel> box = createBox({420, 420, 420});
    FilledCells cells;
    std::string error;
    EXPECT_FALSE(fillCells(*box, Fill::SOLID, 2, cells, error));
    EXPECT_EQ(error, "the filled model has 74088000 cells; expected at most 67108864, as at a lower resolution");
    EXPECT_TRUE(cells.bricks.empty());
}

} // namespace

} // namespace osgLego::test
