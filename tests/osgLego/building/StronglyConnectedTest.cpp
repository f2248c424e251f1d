#include <osgLego/building/StronglyConnected.h>

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Nodes = std::vector<std::uint32_t>;

TEST(StronglyConnected, GroupsAreTheNodesThatReachEachOtherInRandomGraphs)
{
    std::mt19937 random(1);
    std::size_t numGroups = 0;
    for (int round = 0; round < 300; ++round)
    {
        const std::size_t numNodes = 2 + random() % 9;
        std::vector<Nodes> next(numNodes);
        std::vector<std::vector<bool>> reaches(numNodes, std::vector<bool>(numNodes, false));
        for (std::size_t edge = random() % (2 * numNodes); edge > 0; --edge)
        {
            const std::size_t from = random() % numNodes;
            const std::size_t to = random() % numNodes;
            next[from].push_back(static_cast<std::uint32_t>(to));
            reaches[from][to] = true;
        }
        for (std::size_t middle = 0; middle < numNodes; ++middle) // Floyd and Warshall
            for (std::size_t from = 0; from < numNodes; ++from)
                for (std::size_t to = 0; to < numNodes; ++to)
                    if (reaches[from][middle] && reaches[middle][to]) reaches[from][to] = true;
        std::vector<Nodes> groupOf(numNodes);
        for (const Nodes& group : findStronglyConnected(numNodes, [&next](std::uint32_t node)
                                                        { return std::span<const std::uint32_t>(next[node]); }))
        {
            EXPECT_GT(group.size(), 1u) << round;
            for (const std::uint32_t node : group)
                groupOf[node] = group;
            ++numGroups;
        }
        for (std::size_t node = 0; node < numNodes; ++node)
        {
            Nodes expected;
            for (std::size_t other = 0; other < numNodes; ++other)
                if (other == node || (reaches[node][other] && reaches[other][node]))
                    expected.push_back(static_cast<std::uint32_t>(other));
            EXPECT_EQ(groupOf[node], expected.size() > 1 ? expected : Nodes()) << round;
        }
    }
    EXPECT_GT(numGroups, 100u);
}

} // namespace

} // namespace osgLego::test
