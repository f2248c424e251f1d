#include <osgLego/stability/EliminationTree.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** The places of a square grid of blocks that are connected to their neighbours. */
std::vector<std::pair<std::int32_t, std::int32_t>> createGridPlaces(std::int32_t length)
{
    std::vector<std::pair<std::int32_t, std::int32_t>> grid;
    for (std::int32_t block = 0; block < length * length; ++block)
    {
        if (block % length + 1 < length) grid.emplace_back(block + 1, block);
        if (block / length + 1 < length) grid.emplace_back(block, block + length);
    }
    return grid;
}

TEST(EliminationTree, RanksAreAPermutation)
{
    const EliminationTree tree(400, createGridPlaces(20), {});
    const std::set<std::uint32_t> ranks(tree.getRanks().begin(), tree.getRanks().end());
    EXPECT_EQ(ranks.size(), 400u);
    EXPECT_EQ(*ranks.rbegin(), 399u);
}

TEST(EliminationTree, FrontsOfParentsHaveTheRowsOfTheirChildren)
{
    const EliminationTree tree(400, createGridPlaces(20), {});
    const auto& supernodes = tree.getSupernodes();
    std::uint32_t rank = 0;
    for (std::uint32_t index = 0; index < supernodes.size(); ++index)
    {
        const EliminationTree::Supernode& supernode = supernodes[index];
        EXPECT_EQ(supernode.first, rank);
        rank += supernode.numColumns;
        EXPECT_TRUE(std::is_sorted(supernode.rows.begin(), supernode.rows.end()));
        for (const std::uint32_t child : supernode.children)
        {
            EXPECT_LT(child, index);
            EXPECT_GE(child, supernode.firstDescendant);
            EXPECT_EQ(supernodes[child].parent, index);
        }
        if (supernode.rows.empty()) continue;
        const EliminationTree::Supernode& parent = supernodes[supernode.parent];
        ASSERT_EQ(supernode.targets.size(), supernode.rows.size());
        for (std::size_t row = 0; row < supernode.rows.size(); ++row)
        {
            const std::uint32_t target = supernode.targets[row];
            EXPECT_EQ(target < parent.numColumns ? parent.first + target : parent.rows[target - parent.numColumns],
                      supernode.rows[row]);
        }
    }
    EXPECT_EQ(rank, 400u);
}

TEST(EliminationTree, EveryBlockHasAPlace)
{
    const auto places = createGridPlaces(20);
    const EliminationTree tree(400, places, {});
    for (const auto& [row, column] : places)
    {
        const auto [low, high] = std::minmax(tree.getRanks()[static_cast<std::size_t>(row)],
                                             tree.getRanks()[static_cast<std::size_t>(column)]);
        const EliminationTree::Supernode& supernode = tree.getSupernodes()[tree.findSupernode(low)];
        EXPECT_TRUE(high < supernode.first + supernode.numColumns ||
                    std::binary_search(supernode.rows.begin(), supernode.rows.end(), high));
    }
}

} // namespace

} // namespace osgLego::test
