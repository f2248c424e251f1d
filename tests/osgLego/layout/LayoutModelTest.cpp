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

TEST(LayoutModel, PartsAreFoundInModelsWithAnyUpAxis)
{
    const LaidParts parts{{{0, 0, 0}, {2, 1, 1}, 0}, {{0, 1, 0}, {1, 2, 1}, 1}, {{0, 0, 1}, {3, 3, 1}, 2}};
    std::vector<PaletteColor> colors(parts.size());
    for (std::size_t color = 0; color < colors.size(); ++color)
        colors[color].color = {static_cast<std::uint8_t>(color), 0, 0};
    for (const UpAxis upAxis : {UpAxis::Z, UpAxis::Y})
    {
        BrickGrid grid;
        grid.upAxis = upAxis;
        grid.dimensions = glm::ivec3(3);
        const osg::ref_ptr<const BrickModel> model = createModel(parts, grid, colors);
        const std::vector<std::uint32_t> indices = findModelIndices(parts, *model);
        ASSERT_EQ(indices.size(), parts.size());
        for (std::size_t part = 0; part < parts.size(); ++part)
            EXPECT_EQ(model->getParts()[indices[part]].color[0], part);
        if (upAxis == UpAxis::Y)
        {
            EXPECT_NE(indices, (std::vector<std::uint32_t>{0, 1, 2})) << "the order does not differ";
        }
    }
}

} // namespace osgLego
