#include <osgLego/search/ExactCover.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr int NO_COVER = std::numeric_limits<int>::max();
constexpr int MANY_NODES = 1000000;

/** Random sets of up to five cells, in the order of their first cells; each cell alone is also a set. */
WindowParts makeRandomWindow(int numCells, std::mt19937& random)
{
    WindowParts window;
    for (int first = 0; first < numCells; ++first)
    {
        window.starts.push_back(static_cast<int>(window.parts.size()));
        const int numParts = 1 + static_cast<int>(random() % 4);
        for (int i = 0; i < numParts; ++i)
        {
            WindowPart part;
            part.cells.add(first);
            for (int cell = 0; cell < 2 * i; ++cell)
                part.cells.add(std::min(first + static_cast<int>(random() % 9), numCells - 1));
            part.cost = 100 + static_cast<int>(random() % 50);
            window.parts.push_back(part);
        }
    }
    window.starts.push_back(static_cast<int>(window.parts.size()));
    return window;
}

/** The cost of the cheapest cover, by dynamic programming over all sets of covered cells that occur. */
int findLeastCost(const WindowParts& window)
{
    std::map<std::vector<bool>, int> costs{{std::vector<bool>(static_cast<std::size_t>(window.getNumCells())), 0}};
    int least = NO_COVER;
    while (!costs.empty())
    {
        const auto [covered, cost] = *costs.begin();
        costs.erase(costs.begin());
        const auto first = std::find(covered.begin(), covered.end(), false) - covered.begin();
        if (first == window.getNumCells())
        {
            least = std::min(least, cost);
            continue;
        }
        for (const WindowPart& part : window.parts)
        {
            std::vector<bool> next = covered;
            bool isFree = part.cells.getFirst() == first;
            part.cells.visit(
                [&](int cell)
                {
                    isFree = isFree && !next[static_cast<std::size_t>(cell)];
                    next[static_cast<std::size_t>(cell)] = true;
                });
            if (!isFree) continue;
            const auto known = costs.emplace(next, cost + part.cost).first;
            known->second = std::min(known->second, cost + part.cost);
        }
    }
    return least;
}

} // namespace

TEST(ExactCover, CostsAsMuchAsTheCheapestCover)
{
    std::mt19937 random(1);
    ExactCover cover;
    for (int i = 0; i < 200; ++i)
    {
        const WindowParts window = makeRandomWindow(3 + i % 14, random);
        const int least = findLeastCost(window);
        std::vector<int> chosen;
        ASSERT_TRUE(cover.findCheaper(window, least + 1, MANY_NODES, chosen));
        int cost = 0;
        WindowCells cells;
        int numCells = 0;
        for (const int part : chosen)
        {
            cost += window.parts[static_cast<std::size_t>(part)].cost;
            cells |= window.parts[static_cast<std::size_t>(part)].cells;
            window.parts[static_cast<std::size_t>(part)].cells.visit([&](int) { ++numCells; });
        }
        EXPECT_EQ(cost, least);
        EXPECT_EQ(numCells, window.getNumCells());
        for (int cell = 0; cell < window.getNumCells(); ++cell)
            EXPECT_TRUE(cells.contains(cell));
        EXPECT_FALSE(cover.findCheaper(window, least, MANY_NODES, chosen)) << "a cover can't be cheaper";
    }
}

TEST(ExactCover, FailsIfACellHasNoPart)
{
    WindowParts window;
    window.starts = {0, 1, 1};
    window.parts.resize(1);
    window.parts[0].cells.add(0);
    ExactCover cover;
    std::vector<int> chosen{42};
    EXPECT_FALSE(cover.findCheaper(window, NO_COVER, MANY_NODES, chosen));
    EXPECT_EQ(chosen, std::vector<int>{42});
}

TEST(ExactCover, StopsAfterTheGivenNumberOfSteps)
{
    std::mt19937 random(3);
    const WindowParts window = makeRandomWindow(128, random);
    ExactCover cover;
    std::vector<int> chosen;
    cover.findCheaper(window, NO_COVER, 5000, chosen);
    EXPECT_GT(cover.getNumNodes(), 501) << "the window is too easy";
    cover.findCheaper(window, NO_COVER, 500, chosen);
    EXPECT_EQ(cover.getNumNodes(), 501);
}

} // namespace osgLego
