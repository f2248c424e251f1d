#include <osgLego/data/BrickNeighbors.h>

#include <bit>
#include <cstddef>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** The visible bricks of a model, and a plain way to look their cells up. */
class NeighborModel
{
public:
    explicit NeighborModel(const std::vector<glm::ivec3>& cells)
    {
        BrickGrid grid;
        grid.dimensions = glm::ivec3(40);
        std::vector<Brick> bricks(cells.size());
        for (std::size_t index = 0; index < cells.size(); ++index)
            for (int axis = 0; axis < 3; ++axis)
                bricks[index].cell[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(cells[index][axis]);
        points = createBrickPoints(*BrickModel::create(grid, bricks)).points;
        for (const BrickPoint& point : points)
            _cells.insert(keyOf(unpackBrick(point).getCell()));
    }

    bool isCovered(const glm::ivec3& cell) const { return _cells.contains(keyOf(cell)); }

    std::vector<BrickPoint> points;

private:
    using Key = std::tuple<int, int, int>;
    static Key keyOf(const glm::ivec3& cell) { return {cell.x, cell.y, cell.z}; }

    std::set<Key> _cells;
};

bool hasBit(const BrickNeighbors& neighbors, int bit)
{
    return (neighbors[static_cast<std::size_t>(bit / 32)] >> (bit % 32) & 1u) != 0;
}

/** Check each bit of each brick, with the places of the header's description. */
void checkAll(const NeighborModel& model)
{
    const std::vector<BrickNeighbors> all = createBrickNeighbors(model.points);
    ASSERT_EQ(all.size(), model.points.size());
    for (std::size_t index = 0; index < all.size(); ++index)
    {
        const Brick brick = unpackBrick(model.points[index]);
        const BrickNeighbors& neighbors = all[index];
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                {
                    const glm::ivec3 step(dx, dy, dz);
                    const glm::ivec3 upper = (step + 1) / 2;
                    const int numSteps = std::abs(dx) + std::abs(dy) + std::abs(dz);
                    int bit = 12 + upper.x + 2 * upper.y + 4 * upper.z;
                    if (numSteps == 2 && dx == 0) bit = upper.y + 2 * upper.z;
                    if (numSteps == 2 && dy == 0) bit = 4 + upper.z + 2 * upper.x;
                    if (numSteps == 2 && dz == 0) bit = 8 + upper.x + 2 * upper.y;
                    if (numSteps < 2) continue;
                    ASSERT_EQ(hasBit(neighbors, bit), model.isCovered(brick.getCell() + step))
                        << index << ": " << dx << ' ' << dy << ' ' << dz;
                }
        int bit = 20;
        for (int side = 0; side < 6; ++side)
            for (int layer = 2; layer <= (std::popcount(brick.openSides) < 5 ? 3 : 2); ++layer)
            {
                if ((brick.openSides >> side & 1) == 0) continue;
                const int axis = side / 2;
                for (int place = 0; place < 9; ++place, ++bit)
                {
                    glm::ivec3 cell = brick.getCell();
                    cell[axis] += side % 2 == 1 ? layer : -layer;
                    cell[(axis + 1) % 3] += place % 3 - 1;
                    cell[(axis + 2) % 3] += place / 3 - 1;
                    ASSERT_EQ(hasBit(neighbors, bit), model.isCovered(cell)) << index << ", side " << side;
                }
            }
        for (; bit < 96; ++bit)
            ASSERT_FALSE(hasBit(neighbors, bit)) << index;
    }
}

TEST(BrickNeighbors, AreTheCoveredCellsAroundEachBrick)
{
    std::mt19937 random(7);
    for (const unsigned int share : {3u, 10u, 30u, 70u})
    {
        std::vector<glm::ivec3> cells;
        for (int z = 0; z < 21; ++z)
            for (int y = 0; y < 19; ++y)
                for (int x = 0; x < 23; ++x)
                    if (random() % 100 < share) cells.emplace_back(x, y, z);
        checkAll(NeighborModel(cells));
    }
}

TEST(BrickNeighbors, ASingleBrickHasNone)
{
    const NeighborModel model({glm::ivec3(8, 7, 0)});
    EXPECT_EQ(createBrickNeighbors(model.points), std::vector<BrickNeighbors>(1));
    EXPECT_TRUE(createBrickNeighbors({}).empty());
}

TEST(BrickNeighbors, ReachBlocksThatAreNotBesideTheirOwn)
{
    // A tower with a gap: the brick below sees the third layer in the block above.
    const NeighborModel model({glm::ivec3(3, 3, 6), glm::ivec3(3, 3, 9), glm::ivec3(2, 3, 6), glm::ivec3(4, 3, 6)});
    checkAll(model);
    const std::vector<BrickNeighbors> all = createBrickNeighbors(model.points);
    std::size_t number = 0;
    while (unpackBrick(model.points[number]).getCell() != glm::ivec3(3, 3, 6))
        ++number;
    const int top = 20 + 3 * 18; // after -y, +y and -z
    EXPECT_TRUE(hasBit(all[number], top + 9 + 4));
    EXPECT_FALSE(hasBit(all[number], top + 4));
}

} // namespace

} // namespace osgLego::test
