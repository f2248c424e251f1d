#include "LaidMap.h"

#include <Layouts.h>

#include <osgLego/layout/GreedyLayout.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <oneapi/tbb/task_group.h>

namespace osgLego
{

namespace
{

LaidParts lay(const LayoutProblem& problem)
{
    LaidMap laid(problem);
    layGreedily(laid.map, laid.sizes);
    return laid.getParts();
}

/** Layers of cells of one colour. */
LayoutProblem makeBox(std::size_t width, std::size_t depth, std::size_t height)
{
    return drawProblem({height, std::vector<std::string>(depth, std::string(width, 'a'))});
}

TEST(GreedyLayout, TurnsLongPartsInEveryOtherLayer)
{
    EXPECT_EQ(lay(makeBox(8, 8, 3)), (LaidParts{{{0, 0, 0}, {2, 8, 1}, 0},
                                                {{2, 0, 0}, {2, 8, 1}, 0},
                                                {{4, 0, 0}, {2, 8, 1}, 0},
                                                {{6, 0, 0}, {2, 8, 1}, 0},
                                                {{0, 0, 1}, {8, 2, 1}, 0},
                                                {{0, 2, 1}, {8, 2, 1}, 0},
                                                {{0, 4, 1}, {8, 2, 1}, 0},
                                                {{0, 6, 1}, {8, 2, 1}, 0},
                                                {{0, 0, 2}, {2, 8, 1}, 0},
                                                {{2, 0, 2}, {2, 8, 1}, 0},
                                                {{4, 0, 2}, {2, 8, 1}, 0},
                                                {{6, 0, 2}, {2, 8, 1}, 0}}));
}

TEST(GreedyLayout, LaysLargePartsInEitherDirectionAndThenSmallerOnes)
{
    EXPECT_EQ(lay(makeBox(8, 2, 1)), (LaidParts{{{0, 0, 0}, {8, 2, 1}, 0}}));
    EXPECT_EQ(lay(makeBox(5, 1, 1)), (LaidParts{{{0, 0, 0}, {4, 1, 1}, 0}, {{4, 0, 0}, {1, 1, 1}, 0}}));
}

TEST(GreedyLayout, CoversAllCellsEvenIfItsTaskIsCancelled)
{
    const LayoutProblem box = makeBox(8, 8, 3);
    LaidParts parts;
    oneapi::tbb::task_group group;
    group.run_and_wait(
        [&]
        {
            group.cancel();
            parts = lay(box);
        });
    EXPECT_EQ(parts, lay(box));
}

TEST(GreedyLayout, PrefersWideParts)
{
    EXPECT_EQ(lay(drawProblem({{"aaaa", "aa.."}})), (LaidParts{{{0, 0, 0}, {2, 2, 1}, 0}, {{2, 0, 0}, {2, 1, 1}, 0}}));
}

TEST(GreedyLayout, LaysBricksAtTheHeightsThatNeedTheFewestParts)
{
    for (std::size_t first = 0; first < 3; ++first)
    {
        std::vector<std::vector<std::string>> layers(first, {"a..."});
        layers.resize(first + 3, {"aaaa", "aaaa"});
        LayoutProblem problem = drawProblem(layers);
        problem.isOfPlates = true;
        const LaidParts parts = lay(problem);
        ASSERT_EQ(parts.size(), first + 1);
        EXPECT_EQ(parts.back(), (LaidPart{{0, 0, static_cast<std::uint16_t>(first)}, {4, 2, 3}, 0}));
    }
}

} // namespace

} // namespace osgLego
