#include <common/BasePlate.h>

#include <PartModels.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A model of one part, or two at the ends of a footprint. */
osg::ref_ptr<const BrickModel> createModel(const glm::ivec2& footprint)
{
    std::vector<Part> parts(2);
    parts[1].cell = {static_cast<std::uint16_t>(footprint.x - 1), static_cast<std::uint16_t>(footprint.y - 1), 0};
    return BrickModel::createOfParts(createPartGrid({footprint.x, footprint.y, 1}, 1.2), parts);
}

} // namespace

TEST(BasePlateTest, IsTheSmallestOnWhichAModelFits)
{
    EXPECT_EQ(BasePlate(*createModel({8, 16})).getNumber(), "3865");
    EXPECT_EQ(BasePlate(*createModel({9, 16})).getNumber(), "3867");
    EXPECT_EQ(BasePlate(*createModel({30, 12})).getName(), "Base plate 16 x 32");
    EXPECT_EQ(BasePlate(*createModel({48, 40})).getNumber(), "4186");
    EXPECT_EQ(BasePlate(*createModel({30, 12})).createRow().number, "3857");
    EXPECT_EQ(BasePlate(*createModel({48, 40})).getQuantity(), 1u);
}

TEST(BasePlateTest, LargerModelsStandOnSeveralPlates)
{
    const BasePlate plates(*createModel({49, 100}));
    EXPECT_EQ(plates.getQuantity(), 6u);
    const BasePlate narrow(*createModel({58, 2}));
    EXPECT_EQ(narrow.getQuantity(), 2u);
    EXPECT_EQ(narrow.getName(), "Base plate 16 x 32");
    EXPECT_EQ(plates.createModel(false)->getParts().size(), 6u);
}

TEST(BasePlateTest, LiesBelowTheMiddleOfTheModelWithItsStudsInTheModelsCells)
{
    const osg::ref_ptr<const BrickModel> model = createModel({10, 4});
    const BrickGrid& own = model->getGrid();
    const BrickGrid grid = BasePlate(*model).createModel(true)->getGrid();
    EXPECT_EQ(grid.dimensions, glm::ivec3(16, 8, 1));
    EXPECT_DOUBLE_EQ(grid.origin.x, own.origin.x - 3.0 * own.cellSize.x);
    EXPECT_DOUBLE_EQ(grid.origin.y, own.origin.y - 2.0 * own.cellSize.y);
    EXPECT_DOUBLE_EQ(grid.origin.z + grid.cellSize.z, own.origin.z);
}

TEST(BasePlateTest, SaysHowManyOfItsStudsAreLeftOfAndInFrontOfTheModel)
{
    EXPECT_EQ(BasePlate(*createModel({11, 3})).getMargin(), glm::ivec2(2, 2)); // 3 and 3 on the other sides
    // With y upwards, z points to the front.
    std::vector<Part> parts(2);
    parts[1].cell = {10, 0, 2};
    BrickGrid grid = createPartGrid({11, 1, 3}, 1.2);
    grid.upAxis = UpAxis::Y;
    grid.cellSize = {1.0, 1.2, 1.0};
    EXPECT_EQ(BasePlate(*BrickModel::createOfParts(grid, parts)).getMargin(), glm::ivec2(2, 3));
}

} // namespace osgLego::test
