#include <osgLego/data/BuildingBox.h>

#include <PartModels.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(BuildingBox, BoxesTurnedUpsideDownStandOnTheirTop)
{
    EXPECT_EQ(turnUpsideDown({{{1, 2, 3}, {4, 5, 6}}, {{0, 0, 7}, {2, 2, 10}}}),
              (std::vector<BuildingBox>{{{1, 2, 4}, {4, 5, 7}}, {{0, 0, 0}, {2, 2, 3}}}));
}

TEST(BuildingBox, BoxesOfModelsWithYUpwardsHaveTheirFrontAtTheLowestY)
{
    // In the model, z points to the front: the last row of the grid is the front.
    const auto model = BrickModel::createOfParts(createPartGrid({8, 5, 6}, 1.2, UpAxis::Y),
                                                 {{{1, 2, 4}, {3, 1, 2}}, {{0, 0, 0}, {1, 2, 1}}});
    std::vector<BuildingBox> boxes = createBuildingBoxes(*model);
    std::sort(boxes.begin(), boxes.end(),
              [](const BuildingBox& a, const BuildingBox& b) { return a.lower.y < b.lower.y; });
    EXPECT_EQ(boxes, (std::vector<BuildingBox>{{{1, 0, 2}, {4, 2, 3}}, {{0, 5, 0}, {1, 6, 2}}}));
}

} // namespace

} // namespace osgLego::test
