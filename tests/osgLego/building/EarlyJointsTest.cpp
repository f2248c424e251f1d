#include <osgLego/building/EarlyJoints.h>

#include <algorithm>
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

/** Two towers of 2x2 bricks, a tower of others aside, and last a beam on the first two. @param lowest of the second. */
std::vector<BuildingBox> createTowers(int height, int numOthers, int lowest = 0)
{
    std::vector<BuildingBox> boxes;
    for (int layer = 0; layer < height; ++layer)
        boxes.push_back({{0, 0, layer}, {2, 2, layer + 1}});
    for (int layer = lowest; layer < height; ++layer)
        boxes.push_back({{4, 0, layer}, {6, 2, layer + 1}});
    for (int layer = 0; layer < numOthers; ++layer)
        boxes.push_back({{0, 9, layer}, {2, 11, layer + 1}});
    boxes.push_back({{0, 0, height}, {6, 2, height + 1}});
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

/** The place of the last box in the order. */
std::size_t findLast(const std::vector<BuildingBox>& boxes)
{
    const std::vector<std::uint32_t> parts = order(boxes);
    const auto last = static_cast<std::uint32_t>(boxes.size() - 1);
    return static_cast<std::size_t>(std::find(parts.begin(), parts.end(), last) - parts.begin());
}

TEST(EarlyJoints, PiecesAreJoinedAtOnceUnlessAPartWouldJoinThemSoon)
{
    EXPECT_EQ(findLast(createTowers(4, 15)), 23u);
    EXPECT_EQ(findLast(createTowers(4, 16)), 8u);
    EXPECT_EQ(findLast(createTowers(5, 30)), 10u);
}

TEST(EarlyJoints, PiecesOfThreePartsWaitForTheirTurn)
{
    EXPECT_EQ(findLast(createTowers(3, 30)), 36u);
}

TEST(EarlyJoints, PiecesOfThreePartsAreJoinedWhenTheyHaveAFourth)
{
    // Two towers of three bricks, the lowest of which has room for another, and the beam on both. The second one gets
    // its fourth brick later.
    std::vector<BuildingBox> boxes;
    const auto addTower = [&boxes](int left)
    {
        boxes.push_back({{left, 0, 0}, {left + 2, 4, 1}});
        for (const int layer : {1, 2})
            boxes.push_back({{left, 0, layer}, {left + 2, 2, layer + 1}});
    };
    const auto addOthers = [&boxes](int first, int last)
    {
        for (int layer = first; layer < last; ++layer)
            boxes.push_back({{12, 8, layer}, {14, 10, layer + 1}});
    };
    addTower(0);
    boxes.push_back({{0, 2, 1}, {2, 4, 2}});
    addTower(4);
    addOthers(0, 10);
    boxes.push_back({{4, 2, 1}, {6, 4, 2}});
    addOthers(10, 40);
    boxes.push_back({{0, 0, 3}, {6, 2, 4}});
    EXPECT_EQ(findLast(boxes), 18u);
}

TEST(EarlyJoints, PiecesThatDoNotReachTheBaseWaitForTheirTurn)
{
    EXPECT_EQ(findLast(createTowers(5, 30, 1)), 39u);
}

TEST(EarlyJoints, PiecesAreJoinedAsSoonAsAllPartsBelowAreInPlace)
{
    // A brick between the towers, which the beam would hide from a hand, comes in the middle of the others.
    std::vector<BuildingBox> boxes = createTowers(4, 40);
    boxes.insert(boxes.begin() + 18, {{2, 0, 0}, {4, 2, 1}});
    EXPECT_EQ(findLast(boxes), 19u);
}

/** Two towers on the left and, after a tower in the middle, two on the right that mirror them. Last come the rest of
 * the middle tower, and a beam on either pair. */
std::vector<BuildingBox> createMirroredTowers()
{
    std::vector<BuildingBox> boxes;
    const auto addTowers = [&boxes](int left)
    {
        for (int layer = 0; layer < 4; ++layer)
            for (const int x : {left, left + 4})
                boxes.push_back({{x, 0, layer}, {x + 2, 2, layer + 1}});
    };
    addTowers(0);
    for (int layer = 0; layer < 30; ++layer)
        boxes.push_back({{9, 4, layer}, {11, 6, layer + 1}});
    addTowers(14);
    for (int layer = 30; layer < 60; ++layer)
        boxes.push_back({{9, 4, layer}, {11, 6, layer + 1}});
    boxes.push_back({{0, 0, 4}, {6, 2, 5}});
    boxes.push_back({{14, 0, 4}, {20, 2, 5}});
    return boxes;
}

TEST(EarlyJoints, MirroredPartsThatJoinPiecesArePlacedTogetherAsSoonAsBothCanBe)
{
    const std::vector<std::uint32_t> parts = order(createMirroredTowers());
    EXPECT_EQ(parts[46], 76u);
    EXPECT_EQ(parts[47], 77u);
}

TEST(EarlyJoints, APairIsEarlyEvenIfOnlyTheFirstOfItJoinsLargePieces)
{
    // The towers on the right are joined below their last layer, so that the beam on them joins nothing.
    std::vector<BuildingBox> boxes = createMirroredTowers();
    boxes[44] = {{14, 0, 3}, {20, 2, 4}};
    boxes.erase(boxes.begin() + 45);
    const std::vector<std::uint32_t> parts = order(boxes);
    EXPECT_EQ(parts[45], 75u);
    EXPECT_EQ(parts[46], 76u);
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
