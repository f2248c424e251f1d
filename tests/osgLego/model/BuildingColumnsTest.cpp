#include <osgLego/BuildingPlanner.h>
#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/layout/LayoutModel.h>
#include <osgLego/model/BuildingColumns.h>
#include <osgLego/model/LayoutPieces.h>
#include <osgLego/model/LayoutStanding.h>
#include <osgLego/model/SupportColumns.h>

#include <algorithm>
#include <atomic>
#include <functional>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

const std::function<bool()> NEVER;

/** Add a box of bricks of at most 2x2 cells, which cross the joints of the layer below. */
void addBox(SupportedLayout& layout, const glm::ivec3& lower, const glm::ivec3& upper)
{
    for (int z = lower.z; z < upper.z; ++z)
    {
        for (int y = lower.y; y < upper.y; ++y)
            for (int x = lower.x; x < upper.x; ++x)
                layout.problem.cells.push_back(
                    {{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(z)}, 0});
        for (int y = lower.y - z % 2; y < upper.y; y += 2)
            for (int x = lower.x - z % 2; x < upper.x; x += 2)
            {
                const glm::ivec2 first = glm::max(glm::ivec2(x, y), glm::ivec2(lower));
                const glm::ivec2 size = glm::min(glm::ivec2(x, y) + 2, glm::ivec2(upper)) - first;
                layout.parts.push_back({{static_cast<std::uint16_t>(first.x), static_cast<std::uint16_t>(first.y),
                                         static_cast<std::uint16_t>(z)},
                                        {static_cast<std::uint8_t>(size.x), static_cast<std::uint8_t>(size.y), 1}});
            }
    }
}

/** Bridges on two narrow posts, each of which tips over with a part of the bridge alone. They do not touch each other.
 * @param length in cells. @param depth likewise. */
SupportedLayout createBridges(int length, int numBridges = 1, int depth = 4)
{
    constexpr int CLEARANCE = 2;
    constexpr int TOP = 8;
    SupportedLayout layout;
    layout.problem.size = {length, numBridges * (depth + 1), TOP};
    layout.problem.colors.emplace_back();
    for (int front = 0; front < layout.problem.size.y; front += depth + 1)
    {
        const int back = front + depth;
        addBox(layout, {0, front, 0}, {2, back, CLEARANCE});
        addBox(layout, {length - 2, front, 0}, {length, back, CLEARANCE});
        addBox(layout, {0, front, CLEARANCE}, {length, back, TOP});
    }
    std::sort(layout.parts.begin(), layout.parts.end(), isPlacedBefore<LaidPart>);
    std::sort(layout.problem.cells.begin(), layout.problem.cells.end(), isPlacedBefore<LayoutCell>);
    return layout;
}

osg::ref_ptr<const BuildingPlan> plan(const SupportedLayout& layout)
{
    return planBuilding(*createStandingModel(layout.problem, layout.parts));
}

/** @param upAxis of the model that is planned. */
bool addColumnsTo(SupportedLayout& layout, const std::function<bool()>& isCancelled, UpAxis upAxis = UpAxis::Z)
{
    const auto create = [&](const LaidParts& parts)
    {
        if (upAxis == UpAxis::Z) return createStandingModel(layout.problem, parts);
        const glm::ivec3& size = layout.problem.size;
        BrickGrid grid;
        grid.upAxis = upAxis;
        grid.cellSize = {1.0, 1.2, 1.0};
        grid.dimensions = {size.x, size.z, size.y};
        return createModel(parts, grid, {PaletteColor()});
    };
    return BuildingColumns(layout, create, isCancelled, {}).run();
}

/** Add columns to bridges, and expect them to keep the limits then. @param mostAdded cells of columns. */
void expectEasyWithColumns(SupportedLayout& layout, std::size_t mostAdded)
{
    const std::size_t numCells = layout.problem.cells.size();
    const std::size_t numPieces = LayoutPieces(layout.parts).getCount();
    ASSERT_TRUE(addColumnsTo(layout, NEVER));
    EXPECT_EQ(findLayoutError(layout.problem, layout.parts), "");
    EXPECT_TRUE(computeStanding(layout.problem, layout.parts, {})->stands);
    EXPECT_EQ(LayoutPieces(layout.parts).getCount(), numPieces);
    EXPECT_LE(layout.problem.cells.size(), numCells + mostAdded);
    EXPECT_GT(layout.numBuildingColumns, 0u);
    EXPECT_EQ(layout.numBuildingColumns, layout.columns.size());
    const osg::ref_ptr<const BuildingPlan> after = plan(layout);
    EXPECT_TRUE(after->keepsLimits());
    EXPECT_EQ(layout.largestSubmodel, after->getLargestSubmodel());
    EXPECT_EQ(layout.deepestSubmodel, after->getDeepestSubmodel());
    EXPECT_EQ(layout.numFallingSteps, after->getNumFalling());
}

TEST(BuildingColumns, KeepSubmodelsWithinTheLimits)
{
    SupportedLayout layout = createBridges(32);
    ASSERT_EQ(findLayoutError(layout.problem, layout.parts), "");
    ASSERT_TRUE(computeStanding(layout.problem, layout.parts, {})->stands);
    const osg::ref_ptr<const BuildingPlan> before = plan(layout);
    ASSERT_FALSE(before->keepsLimits());
    ASSERT_EQ(LayoutPieces(layout.parts).getCount(), 1u);
    expectEasyWithColumns(layout, layout.problem.cells.size() / 10);
    EXPECT_LE(layout.numFallingSteps, before->getNumFalling());
}

TEST(BuildingColumns, CarryWhatHasToBeHeldForAnyUpAxis)
{
    // Parts have other indices in a model with y upwards.
    for (const UpAxis upAxis : {UpAxis::Z, UpAxis::Y})
    {
        SupportedLayout layout = createBridges(10, 3, 2);
        ASSERT_TRUE(addColumnsTo(layout, NEVER, upAxis));
        EXPECT_GT(layout.numBuildingColumns, 0u);
        EXPECT_LE(layout.numFallingSteps, BuildingPlan::MOST_FALLING_STEPS);
    }
}

TEST(BuildingColumns, CarryWhatHasToBeHeld)
{
    // The lower part of each bridge falls until the upper part is in place.
    SupportedLayout layout = createBridges(10, 3, 2);
    ASSERT_EQ(findLayoutError(layout.problem, layout.parts), "");
    const osg::ref_ptr<const BuildingPlan> before = plan(layout);
    ASSERT_LE(before->getLargestSubmodel(), BuildingPlan::MOST_SUBMODEL_PARTS);
    ASSERT_LE(before->getDeepestSubmodel(), BuildingPlan::DEEPEST_SUBMODEL);
    ASSERT_GT(before->getNumFalling(), BuildingPlan::MOST_FALLING_STEPS);
    ASSERT_EQ(LayoutPieces(layout.parts).getCount(), 3u);
    expectEasyWithColumns(layout, layout.problem.cells.size() / 5);
}

TEST(BuildingColumns, AreOnlyThoseWithoutWhichTheModelIsHarderToBuild)
{
    SupportedLayout layout = createBridges(10, 4, 2);
    ASSERT_TRUE(addColumnsTo(layout, NEVER));
    ASSERT_GT(layout.columns.size(), 0u);
    ASSERT_TRUE(plan(layout)->keepsLimits());
    for (const SupportColumn& column : layout.columns)
    {
        const SupportedLayout fewer = removeColumns(layout, {&column, 1});
        EXPECT_FALSE(plan(fewer)->keepsLimits()) << column.place.x << ',' << column.place.y;
    }
}

TEST(BuildingColumns, AreNotAddedToASmallModel)
{
    SupportedLayout layout = createBridges(12);
    ASSERT_TRUE(computeStanding(layout.problem, layout.parts, {})->stands);
    const LaidParts parts = layout.parts;
    ASSERT_TRUE(addColumnsTo(layout, NEVER));
    EXPECT_EQ(layout.parts, parts);
    EXPECT_EQ(layout.columns.size(), 0u);
    EXPECT_EQ(layout.numBuildingColumns, 0u);
    EXPECT_GT(layout.largestSubmodel, 0u);
}

TEST(BuildingColumns, StopAtAnyTime)
{
    for (int numCalls = 1;; numCalls *= 4)
    {
        std::atomic<int> numLeft = numCalls;
        SupportedLayout layout = createBridges(10, 3, 2);
        if (!addColumnsTo(layout, [&numLeft] { return --numLeft < 0; })) continue;
        EXPECT_GT(numCalls, 64);
        return;
    }
}

TEST(BuildingColumns, StopWhenTheyAreCancelled)
{
    SupportedLayout layout = createBridges(12);
    const LaidParts parts = layout.parts;
    const std::function<bool()> always = [] { return true; };
    EXPECT_FALSE(addColumnsTo(layout, always));
    EXPECT_EQ(layout.parts, parts);
}

} // namespace

} // namespace osgLego
