#include "BrickTowers.h"
#include "PlainEquilibrium.h"

#include <osgLego/PartType.h>
#include <osgLego/Stability.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double BRICK_HEIGHT = 1.2; // of a brick, in pitches
constexpr std::array<glm::ivec2, 4> DIRECTIONS{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

double toAngle(double tangent)
{
    return std::atan(tangent) * 180.0 / std::numbers::pi;
}

StabilityReport computeTilted(const BrickModel& model, BuildingBase base = BuildingBase::TABLE,
                              std::vector<AddedWeight> weights = {})
{
    return *computeStability(model, {base, {}, std::move(weights), true});
}

osg::ref_ptr<const BrickModel> createTiltedColumn(int count, int width, int depth)
{
    std::vector<Part> parts;
    for (int layer = 0; layer < count; ++layer)
        parts.push_back(createBrick({20, 20, layer}, width, depth));
    return createPartModel(std::move(parts));
}

TEST(TiltSolver, ColumnsTipOverOnATable)
{
    const StabilityReport report = computeTilted(*createTiltedColumn(20, 2, 3));
    ASSERT_TRUE(report.tiltAngles);
    EXPECT_FALSE(report.isTiltBound);
    EXPECT_NEAR((*report.tiltAngles)[0], toAngle(1.0 / (10.0 * BRICK_HEIGHT)), 1e-4);
    EXPECT_NEAR((*report.tiltAngles)[1], toAngle(1.0 / (10.0 * BRICK_HEIGHT)), 1e-4);
    EXPECT_NEAR((*report.tiltAngles)[2], toAngle(1.5 / (10.0 * BRICK_HEIGHT)), 1e-4);
    EXPECT_NEAR((*report.tiltAngles)[3], toAngle(1.5 / (10.0 * BRICK_HEIGHT)), 1e-4);
    // A column of 40 bricks with a margin of 1 falls at a tilt of 2 degrees.
    const StabilityReport thin = computeTilted(*createTiltedColumn(40, 1, 1));
    EXPECT_NEAR(thin.margin, 1.0, 1e-6);
    EXPECT_NEAR((*thin.tiltAngles)[0], thin.tippingAngle.value(), 1e-4);
    EXPECT_LT((*thin.tiltAngles)[0], 2.0);
}

TEST(TiltSolver, FrictionHoldsAPartBesideItsCentreOnOneStudUntilItTurns)
{
    const osg::ref_ptr<const BrickModel> model = createPartModel(
        {createBrick({20, 20, 0}, 2, 2), createBrick({20, 20, 1}, 1, 1), createBrick({20, 20, 2}, 3, 1)});
    EXPECT_NEAR((*computeTilted(*model, BuildingBase::PLATE).tiltAngles)[2], StabilityReport::MOST_TILT, 1e-4);
    // A load of 50 g on its middle, one pitch from the stud, has the torque weight * sine about the stud, which the
    // drag of one contact point holds at a quarter of the pitch.
    constexpr double GRAMS = 50.0;
    const double weight = 9.8e-3 * (GRAMS + findPartType(model->getParts()[2], model->getGrid())->mass);
    const double angle = std::asin(0.25 * StabilityReport::CAPACITY / weight) * 180.0 / std::numbers::pi;
    const StabilityReport loaded = computeTilted(*model, BuildingBase::PLATE, {{2, GRAMS}});
    EXPECT_TRUE(loaded.safe);
    EXPECT_NEAR((*loaded.tiltAngles)[2], angle, 1e-3);
    EXPECT_NEAR((*loaded.tiltAngles)[3], angle, 1e-3);
}

TEST(TiltSolver, JointsBreakBeforeColumnsOnAPlateTipOver)
{
    // The lowest stud of a column of 60 bricks 1 x 1: it turns about a point a quarter of the pitch from the axis, and
    // the drags opposite and at the sides have levers of 1/2, 1/4 and 1/4: capacity = weight * (height * sine - cosine
    // / 4). The column bears a few degrees, and much less with 100 g on top.
    constexpr double WEIGHT = 9.8e-3 * 0.43 * 60;
    const double middle = 30.0 * BRICK_HEIGHT;
    const auto findAngle = [](double weight, double height)
    {
        double angle = 0.0;
        while (weight * (height * std::sin(angle) - 0.25 * std::cos(angle)) < StabilityReport::CAPACITY)
            angle += 1e-7;
        return angle * 180.0 / std::numbers::pi;
    };
    const StabilityReport report = computeTilted(*createTiltedColumn(60, 1, 1), BuildingBase::PLATE);
    for (const double angle : *report.tiltAngles)
        EXPECT_NEAR(angle, findAngle(WEIGHT, middle), 1e-4);
    const double loaded = WEIGHT + 0.98;
    const StabilityReport heavy = computeTilted(*createTiltedColumn(60, 1, 1), BuildingBase::PLATE, {{59, 100.0}});
    EXPECT_NEAR((*heavy.tiltAngles)[3], findAngle(loaded, (WEIGHT * middle + 0.98 * 60.0 * BRICK_HEIGHT) / loaded),
                1e-4);
}

TEST(TiltSolver, AgreesWithBisectionByClpOnRandomTowers)
{
    int numBroken = 0;
    int numTipped = 0;
    for (unsigned int seed = 500; seed < 512; ++seed)
        for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
        {
            const osg::ref_ptr<const BrickModel> model = createRandomTower(seed, 10);
            const std::vector<AddedWeight> weights{{9, 30.0}};
            const StabilityReport report = computeTilted(*model, base, weights);
            ASSERT_TRUE(report.tiltAngles) << seed;
            for (std::size_t side = 0; side < DIRECTIONS.size(); ++side)
            {
                const double angle = (*report.tiltAngles)[side];
                if (report.falls())
                {
                    EXPECT_EQ(angle, 0.0) << seed;
                    continue;
                }
                EXPECT_NEAR(angle, toAngle(computePlainTilt(*model, base, DIRECTIONS[side], weights)), 1e-3)
                    << seed << " " << side;
                numBroken += base == BuildingBase::PLATE && angle < StabilityReport::MOST_TILT;
                numTipped += base == BuildingBase::TABLE && angle < StabilityReport::MOST_TILT;
            }
        }
    EXPECT_GT(numBroken, 5);
    EXPECT_GT(numTipped, 5);
}

TEST(TiltSolver, FlatModelsStandUpToTheGreatestTilt)
{
    const StabilityReport report = computeTilted(*createPartModel({createBrick({0, 0, 0}, 2, 4)}));
    for (const double angle : *report.tiltAngles)
        EXPECT_NEAR(angle, StabilityReport::MOST_TILT, 1e-4);
}

TEST(TiltSolver, TheAngleIsThatOfTheWorstPieceOnEachSide)
{
    // A column that is thin along x, and one that is thin along y.
    std::vector<Part> parts;
    for (int layer = 0; layer < 10; ++layer)
    {
        parts.push_back(createBrick({10, 10, layer}, 1, 4));
        parts.push_back(createBrick({30, 30, layer}, 6, 2));
    }
    const StabilityReport report = computeTilted(*createPartModel(std::move(parts)));
    EXPECT_NEAR((*report.tiltAngles)[1], toAngle(0.5 / (5.0 * BRICK_HEIGHT)), 1e-4);
    EXPECT_NEAR((*report.tiltAngles)[3], toAngle(1.0 / (5.0 * BRICK_HEIGHT)), 1e-4);
}

TEST(TiltSolver, AnglesAreZeroForModelsThatFallAndUnsetUnlessTheyAreAskedFor)
{
    const osg::ref_ptr<const BrickModel> cantilever =
        createPartModel({createBrick({0, 0, 0}, 1, 1), createBrick({0, 0, 1}, 8, 1)});
    EXPECT_EQ(computeTilted(*cantilever).tiltAngles, (std::array<double, 4>{}));
    EXPECT_FALSE(computeStability(*cantilever)->tiltAngles);
    EXPECT_FALSE(computeStability(*createTiltedColumn(2, 2, 2))->tiltAngles);
    EXPECT_FALSE(computeTilted(*createPartModel({})).tiltAngles);
}

TEST(TiltSolver, CanBeCancelled)
{
    const osg::ref_ptr<const BrickModel> model = createTiltedColumn(10, 1, 1);
    int numCalls = 0;
    ASSERT_TRUE(computeStability(*model, {BuildingBase::TABLE, [&] { return ++numCalls < 0; }, {}, false}));
    std::atomic<int> calls = 0;
    EXPECT_FALSE(computeStability(*model, {BuildingBase::TABLE, [&] { return ++calls > numCalls + 5; }, {}, true}));
}

} // namespace

} // namespace osgLego::test
