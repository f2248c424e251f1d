#include <osgLego/CpuLegolizer.h>
#include <osgLego/data/BrickPoints.h>

#include <Meshes.h>
#include <PartModels.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

osg::ref_ptr<const BrickModel> createModel(unsigned int resolution)
{
    LegoSettings settings;
    settings.grid.resolution = resolution;
    return legolizeOnCpu(*test::createSphere(), settings);
}

glm::ivec3 cellOf(const BrickPoint& point)
{
    return {point[0] & 0xffffu, point[0] >> 16, point[1] & 0xffffu};
}

/** Bricks in one layer of blocks that touch no other, in a grid as large as grids of stored bricks can be. */
osg::ref_ptr<const BrickModel> createScattered(unsigned int count)
{
    constexpr int SIDE = 65536;
    BrickGrid grid;
    grid.dimensions = glm::ivec3(SIDE);
    std::mt19937 random(1);
    std::vector<Brick> bricks(count);
    for (Brick& brick : bricks)
        for (std::uint16_t& place : brick.cell)
            place = static_cast<std::uint16_t>(random());
    bricks.front().cell = {0, 0, 0};
    bricks.back().cell = {SIDE - 1, SIDE - 1, 0};
    for (Brick& brick : bricks)
        brick.cell[2] %= BrickPoints::BLOCK_SIDE;
    return BrickModel::create(grid, std::move(bricks));
}

/** Whether blocks hold the bounds and the open sides of their bricks. */
void expectBounds(const BrickPoints& result)
{
    int next = 0;
    for (const BrickBlock& block : result.blocks)
    {
        EXPECT_EQ(block.first, next);
        EXPECT_GT(block.count, 0);
        next += block.count;
        EXPECT_EQ(block.minimum / BrickPoints::BLOCK_SIDE, block.maximum / BrickPoints::BLOCK_SIDE);
        glm::ivec3 minimum(70000);
        glm::ivec3 maximum(-1);
        std::uint32_t open = 0;
        for (int number = block.first; number < next; ++number)
        {
            const BrickPoint& point = result.points[static_cast<std::size_t>(number)];
            minimum = glm::min(minimum, cellOf(point));
            maximum = glm::max(maximum, cellOf(point));
            open |= point[1] >> 16;
        }
        EXPECT_EQ(block.minimum, minimum);
        EXPECT_EQ(block.maximum, maximum);
        EXPECT_EQ(block.openSides, open);
    }
    EXPECT_EQ(static_cast<std::size_t>(next), result.points.size());
}

TEST(BrickPoints, ContainEachVisibleBrickOnce)
{
    for (const unsigned int resolution : {1u, 8u, 9u, 50u})
    {
        const osg::ref_ptr<const BrickModel> model = createModel(resolution);
        const BrickPoints result = createBrickPoints(*model);
        EXPECT_EQ(result.points.size(), model->getNumVisible());
        std::set<BrickPoint> points(result.points.begin(), result.points.end());
        EXPECT_EQ(points.size(), result.points.size());
        for (const BrickPoint& point : points)
        {
            const Brick* brick = model->find(cellOf(point));
            ASSERT_TRUE(brick);
            EXPECT_EQ(point[1] >> 16, brick->openSides);
            EXPECT_EQ(point[2] & 0xffu, brick->color[0]);
            EXPECT_EQ(point[2] >> 8 & 0xffu, brick->color[1]);
            EXPECT_EQ(point[2] >> 16 & 0xffu, brick->color[2]);
            EXPECT_EQ(point[2] >> 24, NO_PART);
        }
    }
}

TEST(BrickPoints, BlocksHoldTheBoundsAndOpenSidesOfTheirBricks)
{
    expectBounds(createBrickPoints(*createModel(50)));
}

TEST(BrickPoints, BlocksWithoutBricksNeedNoMemoryInTheLargestGrid)
{
    const osg::ref_ptr<const BrickModel> model = createScattered(1000);
    const BrickPoints result = createBrickPoints(*model);
    ASSERT_EQ(result.points.size(), model->getBricks().size());
    expectBounds(result);
    for (const BrickPoint& point : result.points)
        EXPECT_TRUE(model->find(cellOf(point)));
}

TEST(BrickPoints, FindBlocksMergesConsecutiveBricksOfTheSamePlace)
{
    const BrickPoints made = createBrickPoints(*createModel(50));
    const std::vector<BrickBlock> found = findBlocks(made.points);
    // In some places, bricks with and without studs are consecutive and so become one block.
    ASSERT_LE(found.size(), made.blocks.size());
    ASSERT_GE(2 * found.size(), made.blocks.size());
    int next = 0;
    glm::ivec3 last(-1);
    for (const BrickBlock& block : found)
    {
        EXPECT_EQ(block.first, next);
        EXPECT_NE(block.minimum / BrickPoints::BLOCK_SIDE, last);
        last = block.minimum / BrickPoints::BLOCK_SIDE;
        EXPECT_EQ(last, block.maximum / BrickPoints::BLOCK_SIDE);
        std::uint32_t open = 0;
        for (int number = next; number < next + block.count; ++number)
        {
            const BrickPoint& point = made.points[static_cast<std::size_t>(number)];
            EXPECT_EQ(cellOf(point), glm::clamp(cellOf(point), block.minimum, block.maximum));
            open |= point[1] >> 16;
        }
        EXPECT_EQ(block.openSides, open);
        next += block.count;
    }
    EXPECT_EQ(static_cast<std::size_t>(next), made.points.size());
}

TEST(BrickPoints, BricksWithAndWithoutStudsAreInSeparateBlocks)
{
    std::size_t numStudded = 0;
    const BrickPoints result = createBrickPoints(*createModel(50));
    for (const BrickBlock& block : result.blocks)
    {
        const bool hasStuds = block.openSides & SIDE_TOP;
        numStudded += hasStuds;
        for (int number = block.first; number < block.first + block.count; ++number)
            EXPECT_EQ((result.points[static_cast<std::size_t>(number)][1] >> 16 & SIDE_TOP) != 0, hasStuds);
    }
    EXPECT_GT(numStudded, 0u);
    EXPECT_LT(numStudded, result.blocks.size());
}

/** The code of a length in cells; see BrickPoint. */
std::uint32_t codeOf(int length)
{
    return length <= 2 ? 0u : length == 3 ? 1u : length == 4 ? 2u : 3u;
}

TEST(BrickPoints, CellsOfPartsHaveTheirJoinedSidesTheirLengthsAndANumberInCommon)
{
    for (const UpAxis up : {UpAxis::Z, UpAxis::Y})
    {
        test::PartFilling filling;
        filling.heights = {1, 3};
        filling.isCovered = [](const glm::ivec3& cell) { return (cell.x / 7 + cell.y / 5 + cell.z / 3) % 4 != 0; };
        const osg::ref_ptr<const BrickModel> model =
            test::createParts(test::createPartGrid({30, 20, 15}, 0.4, up), filling);
        const BrickPoints result = createBrickPoints(*model);
        const BrickPoints ofCells = createBrickPoints(*test::createCells(*model));
        ASSERT_EQ(result.points.size(), ofCells.points.size());
        ASSERT_GT(result.points.size(), 1000u);
        std::map<const Part*, std::uint32_t> numbers;
        for (std::size_t index = 0; index < result.points.size(); ++index)
        {
            const BrickPoint& point = result.points[index];
            EXPECT_EQ(unpackBrick(point), unpackBrick(ofCells.points[index]));
            const Part* part = model->findPart(cellOf(point));
            for (int side = 0; side < 6; ++side)
            {
                glm::ivec3 neighbour = cellOf(point);
                neighbour[side / 2] += side % 2 == 1 ? 1 : -1;
                EXPECT_EQ(point[1] >> (22 + side) & 1u, model->findPart(neighbour) == part ? 1u : 0u);
            }
            EXPECT_EQ(point[1] >> 28 & 3u, codeOf(part->getSize().x));
            EXPECT_EQ(point[1] >> 30, codeOf(up == UpAxis::Y ? part->getSize().z : part->getSize().y));
            EXPECT_NE(point[2] >> 24, NO_PART);
            EXPECT_EQ(numbers.emplace(part, point[2] >> 24).first->second, point[2] >> 24);
        }
        std::set<std::uint32_t> different;
        for (const auto& [part, number] : numbers)
            different.insert(number);
        EXPECT_GT(different.size(), std::min<std::size_t>(numbers.size() / 2, 150u));
    }
}

} // namespace

} // namespace osgLego
