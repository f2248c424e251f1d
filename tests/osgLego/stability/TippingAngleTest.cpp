#include "BrickTowers.h"

#include <osgLego/Stability.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double HEIGHT = 1.2; // of a brick, in pitches

double toDegrees(double tangent)
{
    return std::atan(tangent) * 180.0 / std::numbers::pi;
}

StabilityReport computeColumn(int count, int width, int depth, BuildingBase base = BuildingBase::TABLE)
{
    std::vector<Part> parts;
    for (int layer = 0; layer < count; ++layer)
        parts.push_back(createBrick({20, 20, layer}, width, depth));
    return *computeStability(*createPartModel(std::move(parts)), {base, {}});
}

TEST(TippingAngle, ColumnsTipAboutTheirLowerEdge)
{
    EXPECT_NEAR(computeColumn(1, 2, 4).tippingAngle.value(), toDegrees(1.0 / (0.5 * HEIGHT)), 1e-9);
    EXPECT_NEAR(computeColumn(40, 2, 2).tippingAngle.value(), toDegrees(1.0 / (20.0 * HEIGHT)), 1e-9);
    // 40 bricks stand with a margin of 1, but fall at 2 degrees.
    const StabilityReport thin = computeColumn(40, 1, 1);
    EXPECT_NEAR(thin.margin, 1.0, 1e-6);
    EXPECT_LT(thin.tippingAngle.value(), StabilityReport::SAFE_TILT);
    EXPECT_TRUE(thin.stands);
    EXPECT_FALSE(thin.safe);
    EXPECT_TRUE(computeColumn(40, 2, 2).safe);
    EXPECT_TRUE(computeColumn(40, 1, 1, BuildingBase::PLATE).safe) << "the plate holds it";
    EXPECT_NEAR(thin.tippingAngle.value(), toDegrees(0.5 / (20.0 * HEIGHT)), 1e-9);
}

TEST(TippingAngle, IsThatOfTheNearestEdgeInAnyDirection)
{
    // A brick 2 x 2 with a brick 2 x 4 on top, whose centre is a pitch further along y. Both weights are at 1/2 and 3/2
    // bricks.
    constexpr double MASS_2X2 = 1.15;
    constexpr double MASS_2X4 = 2.16;
    const StabilityReport report =
        *computeStability(*createPartModel({createBrick({20, 20, 0}, 2, 2), createBrick({20, 20, 1}, 2, 4)}));
    const double share = MASS_2X4 / (MASS_2X2 + MASS_2X4);
    EXPECT_NEAR(report.tippingAngle.value(), toDegrees((1.0 - share) / (HEIGHT * (0.5 + share))), 1e-9);
}

TEST(TippingAngle, IsMeasuredFromTheLowestParts)
{
    EXPECT_NEAR(computeStability(*createPartModel({createBrick({20, 20, 7}, 2, 2)}))->tippingAngle.value(),
                toDegrees(1.0 / (0.5 * HEIGHT)), 1e-9);
}

TEST(TippingAngle, IsTheLeastOfAllPieces)
{
    const std::vector<Part> parts{createBrick({10, 10, 0}, 4, 2), createBrick({20, 20, 0}, 1, 1),
                                  createBrick({20, 20, 1}, 1, 1)};
    EXPECT_NEAR(computeStability(*createPartModel(parts))->tippingAngle.value(), toDegrees(0.5 / HEIGHT), 1e-9);
}

TEST(TippingAngle, AnAddedWeightIsOnTopOfItsPart)
{
    // A brick 2 x 2 of 1.15 g, with 200 g in the middle of its top.
    const osg::ref_ptr<const BrickModel> model = createPartModel({createBrick({20, 20, 0}, 2, 2)});
    const double height = HEIGHT * (0.5 * 1.15 + 200.0) / 201.15;
    EXPECT_NEAR(computeStability(*model, {BuildingBase::TABLE, {}, {{0, 200.0}}})->tippingAngle.value(),
                toDegrees(1.0 / height), 1e-9);
}

TEST(TippingAngle, TowersThatStandSideBySideTipOneByOne)
{
    std::vector<Part> parts;
    for (int layer = 0; layer < 10; ++layer)
        for (const int x : {20, 21, 22})
            parts.push_back(createBrick({x, 20, layer}, 1, 4));
    EXPECT_NEAR(computeStability(*createPartModel(parts))->tippingAngle.value(), toDegrees(0.5 / (5.0 * HEIGHT)), 1e-9);
}

TEST(TippingAngle, PiecesBesideTheirFootTipAsAWhole)
{
    // A column with an arm of six pitches tips about its foot; a brick beside it, which hangs in the air, is not held.
    const std::vector<Part> parts{createBrick({20, 20, 0}, 2, 2), createBrick({20, 20, 1}, 8, 2),
                                  createBrick({40, 40, 3}, 2, 2), createBrick({50, 20, 0}, 2, 2)};
    const StabilityReport report = *computeStability(*createPartModel(parts));
    EXPECT_EQ(report.tipping, (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(report.findUnheld(), std::vector<std::uint32_t>{3});
    const StabilityReport onPlate = *computeStability(*createPartModel(parts), {BuildingBase::PLATE, {}});
    EXPECT_TRUE(onPlate.tipping.empty());
}

TEST(TippingAngle, PiecesWhoseJointsBreakDoNotTip)
{
    // The foot is as wide as the arm, on whose end a weight breaks its only stud.
    const std::vector<Part> parts{createBrick({20, 20, 0}, 8, 2), createBrick({20, 20, 1}, 1, 1),
                                  createBrick({20, 20, 2}, 8, 2), createBrick({26, 20, 3}, 2, 2)};
    const StabilityReport report = *computeStability(*createPartModel(parts), {BuildingBase::TABLE, {}, {{3, 300.0}}});
    EXPECT_TRUE(report.falls());
    EXPECT_TRUE(report.tipping.empty());
}

TEST(TippingAngle, IsUnsetOnAPlateAndZeroForModelsThatFall)
{
    EXPECT_FALSE(computeColumn(40, 2, 2, BuildingBase::PLATE).tippingAngle);
    EXPECT_EQ(
        computeStability(*createPartModel({createBrick({0, 0, 0}, 1, 1), createBrick({0, 0, 1}, 8, 1)}))->tippingAngle,
        0.0);
    EXPECT_FALSE(computeStability(*createPartModel({}))->tippingAngle);
}

} // namespace

} // namespace osgLego::test
