#include "BookletModels.h"

#include <booklet/BookletCover.h>

#include <PartModels.h>

#include <array>
#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Lines = std::vector<std::string>;

StabilityReport createReport(bool stands, bool isSafe, std::vector<std::uint32_t> falling = {})
{
    StabilityReport report;
    report.stands = stands;
    report.safe = isSafe;
    report.falling = std::move(falling);
    return report;
}

/** The warnings for a tower, all of whose steps are known. */
Lines warningsOf(const std::optional<StabilityReport>& stability, const TowerSetting& setting = {},
                 BuildingBase base = BuildingBase::TABLE)
{
    std::vector<BuildingStep> steps(1);
    steps[0].parts = {0};
    steps[0].isChecked = true;
    return createWarnings(createTower(setting), stability, *BuildingPlan::create(1, steps), base);
}

} // namespace

TEST(BookletCoverTest, AModelThatStandsSafelyHasNoWarnings)
{
    EXPECT_EQ(warningsOf(createReport(true, true)), Lines{});
}

TEST(BookletCoverTest, WarnsOfWornPartsIfAModelStandsButNotSafely)
{
    EXPECT_EQ(warningsOf(createReport(true, false)),
              Lines{"This model stands, but parts that are worn may not hold it: handle it with care."});
}

TEST(BookletCoverTest, WarnsOfAModelThatTipsEasily)
{
    StabilityReport report = createReport(true, false);
    report.tippingAngle = 0.44;
    EXPECT_EQ(warningsOf(report),
              Lines{"This model stands, but tips over easily, on a table that is tilted by 0.4 degrees: "
                    "lean it against something, or build it on a base plate."});
}

TEST(BookletCoverTest, SaysThatAModelTipsOver)
{
    StabilityReport report = createReport(false, false, {0, 1});
    report.tipping = {0, 1};
    EXPECT_EQ(warningsOf(report), Lines{"This model tips over on a table: its centre of mass is not above its foot. "
                                        "Build it on a base plate, or lean it against something."});
}

TEST(BookletCoverTest, SaysIfItIsUnknownWhetherAModelStands)
{
    StabilityReport report = createReport(false, false);
    report.unknown = {0, 1, 2};
    EXPECT_EQ(warningsOf(report),
              Lines{"It is unknown whether this model stands on a table: the forces between 3 parts "
                    "can't be computed precisely enough."});
}

TEST(BookletCoverTest, SaysWhereAModelFallsAndHowManyParts)
{
    EXPECT_EQ(warningsOf(createReport(false, false, {0, 1, 2})),
              Lines{"This model does not stand on a table: 3 parts would fall. Support it from below, or make it with "
                    "support=on."});
    EXPECT_EQ(warningsOf(createReport(false, false, {4}), {}, BuildingBase::PLATE),
              Lines{"This model does not stand on a base plate: 1 part would fall. Support it from below, or make it "
                    "with support=on."});
}

TEST(BookletCoverTest, SaysIfItWasNotComputedWhetherAModelStands)
{
    EXPECT_EQ(warningsOf(std::nullopt),
              Lines{"It was not computed whether this model stands, since it has so many parts."});
}

TEST(BookletCoverTest, CountsUnheldPartsAndNamesFallingSteps)
{
    EXPECT_EQ(warningsOf(createReport(true, true), {.fallingSteps = {0, 1}}),
              Lines{"After steps 1 and 2, the model, or a submodel, does not stand by itself: hold it there."});
    EXPECT_EQ(warningsOf(createReport(true, true), {.fallingSteps = {1}}),
              Lines{"After step 2, the model, or a submodel, does not stand by itself: hold it there."});
    EXPECT_EQ(warningsOf(createReport(true, true), {.unheldParts = {5}}),
              Lines{"This model can't be built as it is: nothing holds 1 part when it is placed."});
    EXPECT_EQ(warningsOf(createReport(true, true), {.unheldParts = {4, 5}}),
              Lines{"This model can't be built as it is: nothing holds 2 parts when they are placed."});
}

TEST(BookletCoverTest, WarnsOfPartsThatWereNeverMadeOrCannotBeOrdered)
{
    const std::array<std::uint8_t, 3> color{1, 2, 3};
    const auto bricks = BrickModel::createOfParts(createPartGrid({1, 1, 1}, 1.2), {{{0, 0, 0}, {1, 1, 1}, color}});
    std::vector<BuildingStep> steps(1);
    steps[0].parts = {0};
    steps[0].isChecked = true;
    const auto plan = BuildingPlan::create(1, steps);
    EXPECT_EQ(createWarnings(BookletModel(*bricks, *plan, {}), createReport(true, true), *plan, BuildingBase::TABLE),
              (Lines{"Parts never made in this size and colour: 1 part (Brick 1 x 1 in #010203).",
                     "Parts in a colour without a number of BrickLink: 1 part (Brick 1 x 1 in #010203)."}));
}

TEST(BookletCoverTest, CountsStepsAfterWhichNothingIsKnown)
{
    std::vector<BuildingStep> steps(2);
    steps[0].parts = {0};
    steps[1].parts = {1};
    EXPECT_EQ(
        createWarnings(createTower(), createReport(true, true), *BuildingPlan::create(2, steps), BuildingBase::TABLE),
        Lines{"Of 2 steps, it was not computed whether the model stands after them."});
}

} // namespace osgLego::test
