#include <osgLego/BrickModel.h>

#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(BrickModel, SidesTowardsEmptyNeighboursAreOpen)
{
    BrickGrid grid;
    grid.dimensions = glm::ivec3(9, 7, 8);
    std::mt19937 engine(3);
    std::set<std::tuple<int, int, int>> covered;
    std::vector<Brick> bricks;
    for (int x = 0; x < 9; ++x)
        for (int y = 0; y < 7; ++y)
            for (int z = 0; z < 8; ++z)
                if (engine() % 3 != 0)
                {
                    covered.emplace(x, y, z);
                    Brick brick;
                    brick.cell = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                  static_cast<std::uint16_t>(z)};
                    bricks.push_back(brick);
                }

    const osg::ref_ptr<const BrickModel> model = BrickModel::create(grid, bricks);
    ASSERT_EQ(model->getBricks().size(), covered.size());
    std::size_t visible = 0;
    for (const Brick& brick : model->getBricks())
    {
        const auto [x, y, z] = brick.cell;
        unsigned int open = 0;
        if (!covered.contains({x - 1, y, z})) open |= SIDE_LEFT;
        if (!covered.contains({x + 1, y, z})) open |= SIDE_RIGHT;
        if (!covered.contains({x, y - 1, z})) open |= SIDE_FRONT;
        if (!covered.contains({x, y + 1, z})) open |= SIDE_BACK;
        if (!covered.contains({x, y, z - 1})) open |= SIDE_BOTTOM;
        if (!covered.contains({x, y, z + 1})) open |= SIDE_TOP;
        EXPECT_EQ(brick.openSides, open) << x << " " << y << " " << z;
        visible += open != 0 ? 1u : 0u;
        EXPECT_EQ(model->find({x, y, z}), &brick);
    }
    EXPECT_EQ(model->getNumVisible(), visible);
    for (int number = 0; number < 9 * 7 * 8; ++number)
    {
        const glm::ivec3 cell(number % 9, number / 9 % 7, number / 63);
        EXPECT_EQ(model->find(cell) != nullptr, covered.contains({cell.x, cell.y, cell.z}));
    }
    EXPECT_EQ(model->find({-1, 0, 0}), nullptr);
    EXPECT_EQ(model->find({9, 0, 0}), nullptr);
}

} // namespace

} // namespace osgLego
