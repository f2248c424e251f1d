#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/model/LayoutStanding.h>
#include <osgLego/model/StepColumns.h>

#include <Layouts.h>

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

const std::function<bool()> NEVER;
constexpr std::size_t ANY = 1000;

/** A gate of two posts and a beam of two layers. */
SupportedLayout createSupportedGate()
{
    const char* const posts = "a......a";
    const char* const beam = "aaaaaaaa";
    return {drawProblem({{posts}, {posts}, {beam}, {beam}}),
            {{{0, 0, 0}}, {{7, 0, 0}}, {{0, 0, 1}}, {{7, 0, 1}}, {{0, 0, 2}, {8, 1, 1}}, {{0, 0, 3}, {8, 1, 1}}}};
}

// The left post, the lower beam, the right post and the upper beam.
const std::vector<std::uint32_t> RANKS{0, 3, 1, 4, 2, 5};
constexpr std::size_t WITH_LOWER_BEAM = 3;

/** The parts that are placed first, and all columns. */
LaidParts selectPlaced(const SupportedLayout& layout, std::size_t numPlaced)
{
    LaidParts parts = layout.parts;
    const LaidParts all = createSupportedGate().parts;
    std::erase_if(parts,
                  [&](const LaidPart& part)
                  {
                      const auto found = std::find(all.begin(), all.end(), part);
                      return found != all.end() && RANKS[static_cast<std::size_t>(found - all.begin())] >= numPlaced;
                  });
    return parts;
}

TEST(StepColumns, CarryPartsThatFallAfterAStep)
{
    const SupportedLayout layout = createSupportedGate();
    ASSERT_EQ(findLayoutError(layout.problem, layout.parts), "");
    ASSERT_FALSE(computeStanding(layout.problem, selectPlaced(layout, WITH_LOWER_BEAM), {})->stands);
    StepColumns columns(layout, RANKS, NEVER);
    EXPECT_TRUE(columns.run({WITH_LOWER_BEAM}, ANY));
    const SupportedLayout& changed = columns.getLayout();
    EXPECT_EQ(findLayoutError(changed.problem, changed.parts), "");
    EXPECT_EQ(changed.columns.size(), 1u);
    EXPECT_TRUE(computeStanding(changed.problem, selectPlaced(changed, WITH_LOWER_BEAM), {})->stands);
    EXPECT_TRUE(computeStanding(changed.problem, changed.parts, {})->stands);
}

TEST(StepColumns, AreNotAddedForOtherSteps)
{
    const SupportedLayout layout = createSupportedGate();
    StepColumns columns(layout, RANKS, NEVER);
    EXPECT_TRUE(columns.run({2, 5, 6}, ANY));
    EXPECT_EQ(columns.getLayout().parts, layout.parts);
}

TEST(StepColumns, AreNotAddedBeyondTheirLimit)
{
    // A column has two cells.
    const SupportedLayout layout = createSupportedGate();
    const std::size_t numCells = layout.problem.cells.size();
    StepColumns columns(layout, RANKS, NEVER);
    EXPECT_TRUE(columns.run({WITH_LOWER_BEAM}, numCells + 1));
    EXPECT_EQ(columns.getLayout().parts, layout.parts);
    EXPECT_TRUE(columns.run({WITH_LOWER_BEAM}, numCells + 2));
    EXPECT_EQ(columns.getLayout().problem.cells.size(), numCells + 2);
}

TEST(StepColumns, StopWhenTheyAreCancelled)
{
    const std::function<bool()> always = [] { return true; };
    EXPECT_FALSE(StepColumns(createSupportedGate(), RANKS, always).run({WITH_LOWER_BEAM}, ANY));
}

} // namespace

} // namespace osgLego
