#include <osgLego/building/PartOrder.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** Bricks of 1x1 at places. */
std::vector<BuildingBox> createBoxes(const std::vector<glm::ivec3>& places, bool hasAxesExchanged)
{
    std::vector<BuildingBox> boxes;
    for (glm::ivec3 place : places)
    {
        if (hasAxesExchanged) std::swap(place.x, place.y);
        boxes.push_back({place, place + 1});
    }
    return boxes;
}

std::vector<std::uint32_t> sortByRank(const std::vector<BuildingBox>& boxes)
{
    const Symmetry symmetry(boxes);
    const JointGraph graph(boxes);
    const PartOrder order(graph, symmetry);
    std::vector<std::uint32_t> parts(boxes.size());
    std::iota(parts.begin(), parts.end(), 0u);
    std::sort(parts.begin(), parts.end(),
              [&order](std::uint32_t a, std::uint32_t b) { return order.getRank(a) < order.getRank(b); });
    return parts;
}

TEST(PartOrder, WalksToTheNearestPartOfALayerAlongBothAxes)
{
    // A row, with a branch at its second brick: while the row goes on, the ends of the branch are farther away.
    for (const bool hasAxesExchanged : {false, true})
        EXPECT_EQ(sortByRank(createBoxes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}, {1, 2, 0}, {1, 3, 0}},
                                         hasAxesExchanged)),
                  (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(PartOrder, BuildsTheNearestRegionNextAlongBothAxes)
{
    // Three legs, of which the second is nearer to the first along one axis, and farther away altogether.
    for (const bool hasAxesExchanged : {false, true})
        EXPECT_EQ(sortByRank(createBoxes({{0, 0, 0}, {1, 20, 0}, {8, 0, 0}, {0, 0, 1}, {1, 20, 1}, {8, 0, 1}},
                                         hasAxesExchanged)),
                  (std::vector<std::uint32_t>{0, 3, 2, 5, 1, 4}));
}

TEST(PartOrder, BuildsRegionsLayerByLayer)
{
    const std::vector<BuildingBox> boxes = createBoxes({{0, 0, 1}, {1, 0, 1}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}}, false);
    EXPECT_EQ(sortByRank(boxes), (std::vector<std::uint32_t>{4, 3, 2, 1, 0}));
    const Symmetry symmetry(boxes);
    const JointGraph graph(boxes);
    const PartOrder order(graph, symmetry);
    EXPECT_EQ(order.getGroup(2), order.getGroup(4));
    EXPECT_EQ(order.getGroup(0), order.getGroup(1));
    EXPECT_LT(order.getGroup(2), order.getGroup(0));
}

TEST(PartOrder, PartsThatMirrorEachOtherFollowEachOther)
{
    // A row, and a shorter one behind its middle.
    for (const bool hasAxesExchanged : {false, true})
        EXPECT_EQ(sortByRank(createBoxes(
                      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}, {2, 1, 0}, {3, 1, 0}},
                      hasAxesExchanged)),
                  (std::vector<std::uint32_t>{2, 3, 1, 4, 0, 5, 6, 7}))
            << "from the middle outwards";
}

TEST(PartOrder, WalksThereAndBackThroughLargeLayers)
{
    constexpr int SIDE = 48; // more parts than a walk to the nearest part takes
    std::vector<glm::ivec3> places;
    for (int y = 0; y < SIDE; ++y)
        for (int x = 0; x < SIDE; ++x)
            places.emplace_back(x, y, 0);
    const std::vector<BuildingBox> boxes = createBoxes(places, false);
    const std::vector<std::uint32_t> order = sortByRank(boxes);
    for (std::size_t index = 1; index < order.size(); ++index)
    {
        const glm::ivec3 way = boxes[order[index]].lower - boxes[order[index - 1]].lower;
        EXPECT_LE(std::abs(way.x), 1) << index;
        EXPECT_LE(std::abs(way.y), 7) << "no farther than two bands";
    }
}

} // namespace

} // namespace osgLego::test
