#include "PlanCheck.h"

#include <Meshes.h>
#include <PartModels.h>
#include <Settings.h>

#include <common/RacingCar.h>
#include <osgLego/BuildingPlanner.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/Stability.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

Part makePart(const glm::ivec3& cell, const glm::ivec3& size)
{
    Part part;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        part.cell[axis] = static_cast<std::uint16_t>(cell[static_cast<int>(axis)]);
        part.size[axis] = static_cast<std::uint8_t>(size[static_cast<int>(axis)]);
    }
    return part;
}

osg::ref_ptr<const BrickModel> createModel(std::vector<Part> parts, const glm::ivec3& size = glm::ivec3(40))
{
    return BrickModel::createOfParts(createPartGrid(size, 1.2), std::move(parts));
}

/** The index of the part in a cell. */
std::uint32_t indexOf(const BrickModel& model, const glm::ivec3& cell)
{
    return static_cast<std::uint32_t>(model.findPart(cell) - model.getParts().data());
}

osg::ref_ptr<const BuildingPlan> planFast(const BrickModel& model)
{
    PlanningOptions options;
    options.checksStability = false;
    return planBuilding(model, options);
}

/** Expect a plan without mistakes. */
osg::ref_ptr<const BuildingPlan> expectGoodPlan(const BrickModel& model)
{
    osg::ref_ptr<const BuildingPlan> plan = planFast(model);
    EXPECT_EQ(plan ? PlanCheck(model, *plan).toString() : "there is no plan", "");
    return plan;
}

osg::ref_ptr<const BrickModel> createWall(int length, int height)
{
    std::vector<Part> parts;
    for (int z = 0; z < height; ++z)
        for (int x = z % 2 == 0 ? 0 : 2; x + 4 <= length; x += 4)
            parts.push_back(makePart({x, 0, z}, {4, 2, 1}));
    return createModel(std::move(parts), {length, 2, height});
}

TEST(BuildingPlanner, AModelWithoutPartsHasNoSteps)
{
    const auto plan = planFast(*createModel({}));
    ASSERT_TRUE(plan);
    EXPECT_TRUE(plan->getSteps().empty());
}

TEST(BuildingPlanner, OnePartIsOneStep)
{
    const auto plan = expectGoodPlan(*createModel({makePart({3, 4, 5}, {2, 2, 1})}));
    ASSERT_EQ(plan->getSteps().size(), 1u);
    EXPECT_EQ(plan->getSteps()[0].parts, std::vector<std::uint32_t>{0});
}

TEST(BuildingPlanner, AWallIsBuiltInOrdinaryStepsWithoutSubmodels)
{
    const auto model = createWall(40, 12);
    const auto plan = expectGoodPlan(*model);
    EXPECT_TRUE(plan->getSubmodels().empty());
    EXPECT_LE(plan->getSteps().size(), model->getParts().size() / 7);
}

TEST(BuildingPlanner, AHangingBrickIsPlacedWithTheBrickAboveItInTheSameStep)
{
    // A column with a beam on it, and a brick below the end of the beam.
    const auto model = createModel({makePart({0, 0, 0}, {2, 2, 1}), makePart({0, 0, 1}, {2, 2, 1}),
                                    makePart({0, 0, 2}, {8, 2, 1}), makePart({6, 0, 1}, {2, 2, 1})});
    const auto plan = expectGoodPlan(*model);
    EXPECT_TRUE(plan->getSubmodels().empty());
    ASSERT_EQ(plan->getSteps().size(), 1u);
    const std::vector<std::uint32_t>& parts = plan->getSteps()[0].parts;
    ASSERT_EQ(parts.size(), 4u);
    EXPECT_EQ(parts[2], indexOf(*model, {0, 0, 2}));
    EXPECT_EQ(parts[3], indexOf(*model, {6, 0, 1})) << "it is pressed on the beam";
}

TEST(BuildingPlanner, BricksThatHangInAHookBecomeASubmodelWithIt)
{
    // From a beam on a column hang a brick, on which nothing can stand, and a hook: posts, an arm, and a brick on the
    // arm that hangs if the beam is turned upside down.
    std::vector<Part> parts;
    for (int z = 0; z < 5; ++z)
        parts.push_back(makePart({2, 0, z}, {2, 2, 1}));
    parts.push_back(makePart({0, 0, 5}, {8, 2, 1}));
    parts.push_back(makePart({0, 0, 4}, {2, 2, 1}));
    for (int z = 2; z < 5; ++z)
        parts.push_back(makePart({6, 0, z}, {2, 2, 1}));
    parts.push_back(makePart({4, 0, 1}, {4, 2, 1}));
    parts.push_back(makePart({4, 0, 2}, {2, 2, 1}));
    const auto plan = expectGoodPlan(*createModel(std::move(parts)));
    EXPECT_EQ(plan->getSubmodels().size(), 1u) << "few parts that hang in a submodel are placed with the part above";
}

TEST(BuildingPlanner, PartsThatTouchNothingAreListedAndComeLast)
{
    const auto model =
        createModel({makePart({0, 0, 0}, {2, 2, 1}), makePart({0, 0, 1}, {2, 2, 1}), makePart({10, 0, 3}, {2, 2, 1}),
                     makePart({20, 0, 5}, {2, 2, 1}), makePart({20, 0, 6}, {2, 2, 1})});
    const auto plan = expectGoodPlan(*model);
    EXPECT_EQ(plan->getUnheldParts(),
              (std::vector<std::uint32_t>{indexOf(*model, {10, 0, 3}), indexOf(*model, {20, 0, 5}),
                                          indexOf(*model, {20, 0, 6})}));
    EXPECT_EQ(plan->getSteps().size(), 2u);
    EXPECT_EQ(plan->getSubmodels().size(), 1u) << "two parts that hold each other";
    EXPECT_TRUE(plan->getSteps()[0].stands);
    EXPECT_FALSE(plan->getSteps()[1].stands);
    EXPECT_TRUE(plan->getSteps()[1].isChecked) << "it needs no computation";
}

TEST(BuildingPlanner, RandomPartsWithManyHolesAreHeldWhenTheyArePlaced)
{
    // Hooks that interlock can't always be assembled from above; their parts are held when they are placed, but from
    // the side. The order of building decides how many there are.
    std::size_t numUnreachable = 0;
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
        for (std::uint32_t seed = 1; seed < 9; ++seed)
        {
            PartFilling filling;
            filling.heights = {1, 3};
            filling.seed = seed;
            filling.isCovered = [](const glm::ivec3& cell) { return (cell.x * 7 + cell.y * 5 + cell.z * 3) % 11 > 2; };
            const auto model = createParts(createPartGrid({17, 14, 15}, 0.4, up), filling);
            const auto plan = planFast(*model);
            ASSERT_TRUE(plan);
            const PlanCheck check(*model, *plan);
            EXPECT_TRUE(check.getUnheld().empty()) << check.toString();
            EXPECT_TRUE(check.getDisconnected().empty()) << check.toString();
            EXPECT_TRUE(check.getLong().empty()) << check.toString();
            EXPECT_LE(check.getUnreachable().size(), 2u) << "interlocking hooks\n" << check.toString();
            numUnreachable += check.getUnreachable().size();
        }
    EXPECT_LE(numUnreachable, 5u) << "in all 16 models";
}

/** The deepest nesting of submodels in steps. @param largest receives the most parts of a submodel. */
std::size_t findDepth(const BuildingPlan& plan, const std::vector<BuildingStep>& steps, std::size_t& largest)
{
    std::size_t depth = 0;
    for (const BuildingStep& step : steps)
        for (const std::uint32_t submodel : step.submodels)
        {
            const std::vector<BuildingStep>& own = plan.getSubmodels()[submodel].steps;
            depth = std::max(depth, 1 + findDepth(plan, own, largest));
            std::size_t numParts = 0;
            for (const BuildingStep& inner : own)
                numParts += plan.getPlacedParts(inner).size();
            largest = std::max(largest, numParts);
        }
    return depth;
}

TEST(BuildingPlanner, SubmodelsAreNestedAtMostThreeDeepAndHaveAtMost150Parts)
{
    std::size_t numPressedOn = 0;
    for (const bool hasHoles : {false, true})
        for (std::uint32_t seed = 1; seed < 4; ++seed)
        {
            PartFilling filling;
            filling.heights = {1, 3};
            filling.seed = seed;
            filling.isCovered = [hasHoles](const glm::ivec3& cell)
            { return (cell.x * 7 + cell.y * 5 + cell.z * 3) % 11 > (hasHoles ? 4 : 2); };
            const auto model = createParts(createPartGrid({17, 14, 15}, 0.4, UpAxis::Z), filling);
            const auto plan = planFast(*model);
            std::size_t largest = 0;
            EXPECT_LE(findDepth(*plan, plan->getSteps(), largest), 3u) << seed;
            EXPECT_LE(largest, 150u) << seed;
            numPressedOn += PlanCheck(*model, *plan).getNumPressedOn();
        }
    EXPECT_GT(numPressedOn, 0u) << "the limits matter";
}

osg::ref_ptr<const BrickModel> createBricks(const osg::Node& node, const std::string& text)
{
    return legolizeOnCpu(node, parseSettings(text));
}

/** Expect that the parts in place stand after every step that the plan says they do, and that all steps of held parts
 * do. */
void expectStandingSteps(const BrickModel& model)
{
    const osg::ref_ptr<const BuildingPlan> plan = planBuilding(model);
    ASSERT_TRUE(plan);
    EXPECT_EQ(PlanCheck(model, *plan).toString(), "");
    std::vector<std::uint32_t> placed;
    for (const BuildingStep& step : plan->getSteps())
    {
        for (const std::uint32_t part : plan->getPlacedParts(step))
            placed.push_back(part);
        const auto& unheld = plan->getUnheldParts();
        if (std::binary_search(unheld.begin(), unheld.end(), placed.back())) break;
        EXPECT_TRUE(step.stands) << placed.size();
        const std::optional<StabilityReport> report = computeStability(*selectParts(model, placed));
        EXPECT_TRUE(report && report->stands) << placed.size() << " parts";
    }
}

TEST(BuildingPlanner, APartThatWouldFallIsPlacedTogetherWithThePartThatHoldsIt)
{
    // A column that would topple over with a beam to the right, the eighth part, without another one to the left.
    std::vector<Part> parts;
    for (int z = 0; z < 7; ++z)
        parts.push_back(makePart({6, 0, z}, {2, 2, 1}));
    parts.push_back(makePart({6, 0, 7}, {8, 2, 1}));
    parts.push_back(makePart({0, 0, 8}, {8, 2, 1}));
    for (int z = 9; z < 15; ++z)
        parts.push_back(makePart({6, 0, z}, {2, 2, 1}));
    const auto model = createModel(std::move(parts));
    expectStandingSteps(*model);
    const auto plan = planBuilding(*model);
    EXPECT_TRUE(plan->getSubmodels().empty());
    ASSERT_EQ(plan->getSteps().size(), 2u);
    const std::vector<std::uint32_t>& first = plan->getSteps()[0].parts;
    EXPECT_EQ(std::count(first.begin(), first.end(), indexOf(*model, {6, 0, 7})), 1);
    EXPECT_EQ(std::count(first.begin(), first.end(), indexOf(*model, {0, 0, 8})), 1);
    const auto fast = planFast(*model);
    EXPECT_EQ(fast->getNumPlaced(0), 8u) << "without the check of stability, the step ends between the beams";
}

TEST(BuildingPlanner, StepsAreCheckedIfTheOptionsSaySo)
{
    const auto model = createWall(24, 6);
    EXPECT_EQ(planBuilding(*model)->getNumUnchecked(), 0u);
    const auto plan = planFast(*model);
    EXPECT_EQ(plan->getNumUnchecked(), plan->getSteps().size());
}

TEST(BuildingPlanner, PartsInPlaceStandAfterEveryStep)
{
    expectStandingSteps(*createWall(24, 6));
    expectStandingSteps(*createBricks(*createRacingCar(), "24,proportions=brick,parts=bricks"));
}

/** The model turned by a quarter about the up axis: its front becomes its right side. */
osg::ref_ptr<const BrickModel> turn(const BrickModel& model)
{
    const glm::ivec3 size = model.getGrid().dimensions;
    std::vector<Part> parts;
    for (const Part& part : model.getParts())
    {
        const glm::ivec3 cell = part.getCell();
        const glm::ivec3 extent = part.getSize();
        parts.push_back(makePart({size.y - cell.y - extent.y, cell.x, cell.z}, {extent.y, extent.x, extent.z}));
    }
    return createModel(std::move(parts), {size.y, size.x, size.z});
}

/** Expect that each part of a step has its mirror image, in the plane across the x or y axis, in the same step. */
void expectMirroredSteps(const BrickModel& model, int axis)
{
    const auto plan = expectGoodPlan(model);
    for (const BuildingStep& step : plan->getSteps())
        for (const std::uint32_t part : step.parts)
        {
            glm::ivec3 mirrored = model.getParts()[part].getCell();
            mirrored[axis] = model.getGrid().dimensions[axis] - mirrored[axis] - model.getParts()[part].getSize()[axis];
            EXPECT_TRUE(std::count(step.parts.begin(), step.parts.end(), indexOf(model, mirrored))) << part;
        }
}

TEST(BuildingPlanner, PartsThatMirrorEachOtherAreInTheSameStep)
{
    // Six legs in two halves, three in a row, at different distances so that the rows have no other symmetry.
    std::vector<Part> parts;
    for (int z = 0; z < 7; ++z)
        for (const int x : {0, 14})
            for (const int y : {0, 4, 12})
                parts.push_back(makePart({x, y, z}, {2, 2, 1}));
    const auto model = createModel(std::move(parts), {16, 14, 7});
    expectMirroredSteps(*model, 0);
    expectMirroredSteps(*turn(*model), 1);
}

TEST(BuildingPlanner, AWallIsBuiltFromBothEnds)
{
    // A wall with a step in front, so that it has no symmetry but that of its ends.
    std::vector<Part> parts;
    for (int z = 0; z < 6; ++z)
        for (int x = z % 2 == 0 ? 0 : 2; x + 4 <= 80; x += 4)
            parts.push_back(makePart({x, 2, z}, {4, 2, 1}));
    for (int x = 0; x < 80; x += 4)
        parts.push_back(makePart({x, 0, 0}, {4, 2, 1}));
    const auto model = createModel(std::move(parts), {80, 4, 6});
    expectMirroredSteps(*model, 0);
    expectMirroredSteps(*turn(*model), 1);
}

TEST(BuildingPlanner, LegsAreBuiltOneAfterTheOther)
{
    std::vector<Part> parts;
    for (int z = 0; z < 8; ++z)
        for (const int x : {0, 5, 30}) // no symmetry
            parts.push_back(makePart({x, 0, z}, {2, 2, 1}));
    const auto model = createModel(std::move(parts));
    const auto plan = expectGoodPlan(*model);
    ASSERT_EQ(plan->getSteps().size(), 3u);
    for (const BuildingStep& step : plan->getSteps())
        for (const std::uint32_t part : step.parts)
            EXPECT_EQ(model->getParts()[part].cell[0], model->getParts()[step.parts[0]].cell[0]);
}

TEST(BuildingPlanner, AWallIsShownFromOneSide)
{
    const osg::ref_ptr<const BuildingPlan> plan = planFast(*createWall(40, 12));
    for (const BuildingStep& step : plan->getSteps())
        EXPECT_EQ(step.turns, 0);
}

TEST(BuildingPlanner, NoSinglePartIsLeftForTheLastStep)
{
    std::vector<Part> parts;
    for (int z = 0; z < 17; ++z)
        parts.push_back(makePart({0, 0, z}, {2, 2, 1}));
    const auto plan = expectGoodPlan(*createModel(std::move(parts)));
    ASSERT_EQ(plan->getSteps().size(), 2u);
    EXPECT_GE(plan->getSteps()[1].parts.size(), 5u);
}

TEST(BuildingPlanner, APlanThatIsCancelledIsNull)
{
    PlanningOptions options;
    int numCalls = 0;
    options.isCancelled = [&numCalls] { return ++numCalls > 3; };
    EXPECT_FALSE(planBuilding(*createWall(40, 12), options));
}

TEST(BuildingPlanner, ProgressRisesToOne)
{
    PlanningOptions options;
    options.checksStability = false;
    std::vector<double> fractions;
    options.progress = [&fractions](double fraction) { fractions.push_back(fraction); };
    planBuilding(*createWall(40, 12), options);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    ASSERT_FALSE(fractions.empty());
    EXPECT_EQ(fractions.back(), 1.0);
}

TEST(BuildingPlanner, TheRacingCarCanBeBuilt)
{
    expectGoodPlan(*createBricks(*createRacingCar(), "32,proportions=brick,parts=bricks"));
}

TEST(BuildingPlanner, TheBunnyCanBeBuilt)
{
    const auto bunny = readBunny();
    if (!bunny) GTEST_SKIP() << "bunny.ply was not downloaded";
    expectGoodPlan(*createBricks(*bunny, "32,up=y,proportions=brick,parts=bricks"));
    expectGoodPlan(*createBricks(*bunny, "24,up=y,proportions=plate,parts=bricks"));
}

} // namespace

} // namespace osgLego::test
