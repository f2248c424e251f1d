#include <osgLego/building/EarlyJoints.h>

#include <numeric>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A row of bricks of 2x2, and beams of 4x2 on them, each over two bricks, the first one over the first two. */
std::vector<BuildingBox> createRow(int numBricks, int numBeams)
{
    std::vector<BuildingBox> boxes;
    for (int brick = 0; brick < numBricks; ++brick)
        boxes.push_back({{2 * brick, 0, 0}, {2 * brick + 2, 2, 1}});
    for (int beam = 0; beam < numBeams; ++beam)
        boxes.push_back({{4 * beam, 0, 1}, {4 * beam + 4, 2, 2}});
    return boxes;
}

std::vector<std::uint32_t> order(const std::vector<BuildingBox>& boxes)
{
    std::vector<std::uint32_t> parts(boxes.size());
    std::iota(parts.begin(), parts.end(), 0u);
    return joinEarly(JointGraph(boxes), Symmetry(boxes), parts);
}

TEST(EarlyJoints, FiveLoosePartsAreJoinedBeforeTheNextOnes)
{
    // The last brick of the five needs its neighbour first. A single brick aside keeps the row from mirroring itself.
    std::vector<BuildingBox> boxes = createRow(10, 5);
    boxes.push_back({{0, 4, 0}, {2, 10, 1}});
    EXPECT_EQ(order(boxes), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 10, 11, 5, 12, 6, 7, 8, 9, 13, 14, 15}));
}

TEST(EarlyJoints, FewerLoosePartsStayTogether)
{
    EXPECT_EQ(order(createRow(4, 2)), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
}

TEST(EarlyJoints, PartsThatJoinNothingStayInTheirPlace)
{
    // Towers: no part joins two of them.
    std::vector<BuildingBox> boxes;
    for (int layer = 0; layer < 2; ++layer)
        for (int tower = 0; tower < 7; ++tower)
            boxes.push_back({{4 * tower, 0, layer}, {4 * tower + 2, 2, layer + 1}});
    std::vector<std::uint32_t> same(boxes.size());
    std::iota(same.begin(), same.end(), 0u);
    EXPECT_EQ(order(boxes), same);
}

TEST(EarlyJoints, NoPartIsPlacedBeforeOneBelowIt)
{
    // Beams that overlap by half, so that each of them needs one brick more, and a brick under a gap of two layers.
    std::vector<BuildingBox> boxes = createRow(12, 6);
    for (int beam = 0; beam < 5; ++beam)
        boxes.push_back({{4 * beam + 2, 0, 2}, {4 * beam + 6, 2, 3}});
    boxes.push_back({{0, 2, 0}, {2, 4, 1}});
    boxes.push_back({{0, 0, 3}, {2, 4, 4}});
    const JointGraph graph(boxes);
    std::vector<bool> isPlaced(boxes.size(), false);
    const std::vector<std::uint32_t> parts = order(boxes);
    EXPECT_EQ(parts.size(), boxes.size());
    for (const std::uint32_t part : parts)
    {
        for (const PartLink& link : graph.getNextBelow(part))
            EXPECT_TRUE(isPlaced[link.part]) << part;
        EXPECT_FALSE(isPlaced[part]);
        isPlaced[part] = true;
    }
}

} // namespace

} // namespace osgLego::test
