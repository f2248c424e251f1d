#include <osgLego/model/RecoloringCosts.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

const std::vector<PaletteColor> BLUE_AND_PURPLE{{1, "Blue", {30, 90, 168}}, {85, "Medium Lilac", {68, 26, 145}}};

TEST(RecoloringCosts, PurpleCostsMoreThanBlueOnABlueSurface)
{
    BrickGrid grid;
    grid.dimensions = {1, 1, 1};
    const RecoloringCosts costs(*BrickModel::create(grid, {Brick{{0, 0, 0}, {0, 0, 255}}}), BLUE_AND_PURPLE);
    EXPECT_GT(costs.get({0, 0, 0}, 0, 1), 2.0);
    EXPECT_EQ(costs.get({0, 0, 0}, 1, 0), 0.0);
}

} // namespace

} // namespace osgLego
