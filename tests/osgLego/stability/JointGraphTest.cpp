#include "BrickTowers.h"

#include <osgLego/stability/JointGraph.h>

#include <PartModels.h>

#include <map>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** For each part, the columns that it shares with each other part. */
using Links = std::vector<std::map<std::uint32_t, int>>;

Links toLinks(const JointGraph& graph, std::span<const PartLink> (JointGraph::*get)(std::uint32_t) const)
{
    Links links(graph.getNumParts());
    for (std::uint32_t part = 0; part < graph.getNumParts(); ++part)
        for (const PartLink& link : (graph.*get)(part))
            links[part][link.part] += link.studs;
    return links;
}

TEST(JointGraph, LinksPartsAcrossGapsOfAnyHeightButJoinsOnlyThoseThatTouch)
{
    for (const int gap : {0, 1, 2, 3, 50})
    {
        const JointGraph graph({{{0, 0, 0}, {4, 2, 1}}, {{2, 0, 1 + gap}, {6, 2, 2 + gap}}});
        for (const auto get : {&JointGraph::getNextAbove, &JointGraph::getNextBelow})
        {
            const std::uint32_t part = get == &JointGraph::getNextAbove ? 0 : 1;
            ASSERT_EQ((graph.*get)(part).size(), 1u) << gap;
            EXPECT_EQ((graph.*get)(part)[0].part, 1 - part) << gap;
            EXPECT_EQ((graph.*get)(part)[0].studs, 4) << gap;
            EXPECT_TRUE((graph.*get)(1 - part).empty()) << gap;
        }
        EXPECT_EQ(graph.getJointsAbove(0).empty(), gap > 0);
        EXPECT_EQ(graph.getJointsBelow(1).empty(), gap > 0);
    }
}

TEST(JointGraph, JoinsEveryPartOfARandomTowerOfAnySize)
{
    for (const int numParts : {20, 200, 600})
        for (const unsigned int seed : {0u, 1u, 2u, 3u})
        {
            const JointGraph graph(createBuildingBoxes(*createRandomTower(seed, numParts)));
            ASSERT_EQ(graph.getNumParts(), static_cast<std::uint32_t>(numParts));
            for (std::uint32_t part = 0; part < graph.getNumParts(); ++part)
                EXPECT_FALSE(graph.getJointsAbove(part).empty() && graph.getJointsBelow(part).empty()) << part;
        }
}

TEST(JointGraph, LinksTheNextPartOfEachColumnOfRandomModels)
{
    PartFilling filling;
    filling.heights = {1, 3};
    filling.isCovered = [](const glm::ivec3& cell) { return (cell.x * 7 + cell.y * 5 + cell.z * cell.z * 3) % 11 > 5; };
    const glm::ivec3 size(12, 9, 14);
    const auto model = createParts(createPartGrid(size, 0.4), filling);
    const JointGraph graph(createBuildingBoxes(*model));
    Links joints(graph.getNumParts());
    Links next(graph.getNumParts());
    const auto indexOf = [&](const glm::ivec3& cell) -> std::int64_t
    {
        const Part* part = model->findPart(cell);
        return part ? part - model->getParts().data() : -1;
    };
    // Climb each column cell by cell.
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
        {
            std::int64_t below = -1;
            int top = 0;
            for (int z = 0; z < size.z; ++z)
            {
                const std::int64_t part = indexOf({x, y, z});
                if (part < 0) continue;
                if (below >= 0 && part != below)
                {
                    ++next[static_cast<std::size_t>(below)][static_cast<std::uint32_t>(part)];
                    if (top + 1 == z) ++joints[static_cast<std::size_t>(below)][static_cast<std::uint32_t>(part)];
                }
                below = part;
                top = z;
            }
        }
    EXPECT_EQ(toLinks(graph, &JointGraph::getNextAbove), next);
    EXPECT_EQ(toLinks(graph, &JointGraph::getJointsAbove), joints);
    const auto invert = [](const Links& links)
    {
        Links inverse(links.size());
        for (std::uint32_t part = 0; part < links.size(); ++part)
            for (const auto& [other, studs] : links[part])
                inverse[other][part] = studs;
        return inverse;
    };
    EXPECT_EQ(toLinks(graph, &JointGraph::getNextBelow), invert(next));
    EXPECT_EQ(toLinks(graph, &JointGraph::getJointsBelow), invert(joints));
}

TEST(JointGraph, PartsOfTheLowestLayerAreOnTheBase)
{
    const JointGraph graph({{{0, 0, 5}, {1, 1, 6}}, {{3, 0, 3}, {4, 1, 4}}, {{6, 0, 3}, {7, 1, 6}}});
    EXPECT_EQ(graph.getLowestLayer(), 3);
    EXPECT_FALSE(graph.isOnBase(0));
    EXPECT_TRUE(graph.isOnBase(1));
    EXPECT_TRUE(graph.isOnBase(2));
}

} // namespace

} // namespace osgLego::test
