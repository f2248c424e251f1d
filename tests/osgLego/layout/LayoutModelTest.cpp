#include <osgLego/layout/LayoutModel.h>

#include <gtest/gtest.h>

namespace osgLego
{

TEST(LayoutModel, AProblemOfAHollowShellIsHollow)
{
    BrickGrid grid;
    grid.dimensions = glm::ivec3(7);
    std::vector<Brick> bricks;
    for (std::uint16_t z = 0; z < 7; ++z)
        for (std::uint16_t y = 0; y < 7; ++y)
            for (std::uint16_t x = 0; x < 7; ++x)
                if (x % 6 == 0 || y % 6 == 0 || z % 6 == 0) bricks.push_back({{x, y, z}, {200, 10, 20}});
    const osg::ref_ptr<const BrickModel> box = BrickModel::create(grid, bricks);
    const auto create = [&](Fill fill, unsigned int shell)
    {
        FilledCells cells;
        std::string error;
        EXPECT_TRUE(fillCells(*box, fill, shell, cells, error)) << error;
        return createProblem(cells, grid, collectColors(cells));
    };
    EXPECT_TRUE(create(Fill::SHELL, 2).isHollow);
    EXPECT_FALSE(create(Fill::SHELL, 2).isSolid());
    EXPECT_FALSE(create(Fill::SHELL, 4).isHollow);
    EXPECT_TRUE(create(Fill::SHELL, 4).isSolid());
    EXPECT_FALSE(create(Fill::SOLID, 2).isHollow);
    EXPECT_TRUE(create(Fill::SOLID, 2).isSolid());
    EXPECT_FALSE(create(Fill::SURFACE, 2).isHollow);
    EXPECT_FALSE(create(Fill::SURFACE, 2).isSolid());
}

} // namespace osgLego
