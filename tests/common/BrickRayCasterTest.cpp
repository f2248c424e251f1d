#include "EveryBrick.h"

#include <common/BrickRayCaster.h>
#include <common/RacingCar.h>
#include <osgLego/CpuLegolizer.h>

#include <HeapSize.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr double FAR = std::numeric_limits<double>::infinity();
constexpr double PI = std::numbers::pi;

osg::ref_ptr<const BrickModel> createModel(const BrickGrid& grid, const std::function<bool(const glm::ivec3&)>& covers)
{
    std::vector<Brick> bricks;
    glm::ivec3 cell;
    for (cell.z = 0; cell.z < grid.dimensions.z; ++cell.z)
        for (cell.y = 0; cell.y < grid.dimensions.y; ++cell.y)
            for (cell.x = 0; cell.x < grid.dimensions.x; ++cell.x)
            {
                if (!covers(cell)) continue;
                Brick brick;
                for (int axis = 0; axis < 3; ++axis)
                    brick.cell[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(cell[axis]);
                bricks.push_back(brick);
            }
    return BrickModel::create(grid, bricks);
}

/** A model of cubes with studs towards +z. */
osg::ref_ptr<const BrickModel> createModel(const glm::ivec3& dimensions,
                                           const std::function<bool(const glm::ivec3&)>& covers)
{
    BrickGrid grid;
    grid.dimensions = dimensions;
    return createModel(grid, covers);
}

osg::ref_ptr<const BrickModel> createCar(Proportions proportions, UpAxis up)
{
    LegoSettings settings;
    settings.grid.resolution = 16;
    settings.grid.proportions = proportions;
    settings.grid.upAxis = up;
    return legolizeOnCpu(*createRacingCar(), settings);
}

template <typename Test>
void forEachCar(const Test& test)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
        for (const Proportions proportions : {Proportions::CUBE, Proportions::BRICK, Proportions::PLATE})
        {
            SCOPED_TRACE(testing::Message()
                         << "up " << static_cast<int>(up) << ", proportions " << static_cast<int>(proportions));
            test(*createCar(proportions, up));
        }
}

/** Random rays in and around a grid. */
class RandomRays
{
public:
    RandomRays(const BrickGrid& grid, unsigned int seed) :
        _engine(seed), _size(glm::dvec3(grid.dimensions) * grid.cellSize / grid.getPitch())
    {
    }

    glm::dvec3 makeOrigin(double reach = 0.5)
    {
        std::uniform_real_distribution<double> place(-reach, 1.0 + reach);
        const double x = place(_engine);
        const double y = place(_engine);
        const double z = place(_engine);
        return _size * glm::dvec3(x, y, z);
    }
    glm::dvec3 makeDirection() { return glm::normalize(makeOrigin(3.0) - makeOrigin(3.0)); }
    glm::dvec3 makeAxisDirection()
    {
        glm::dvec3 direction(0.0);
        direction[static_cast<int>(_engine() % 3)] = _engine() % 2 == 0 ? 1.0 : -1.0;
        return direction;
    }

private:
    std::mt19937 _engine;
    glm::dvec3 _size;
};

void expectSame(const std::optional<double>& found, const std::optional<double>& expected)
{
    ASSERT_EQ(found.has_value(), expected.has_value());
    ASSERT_NEAR(found.value_or(0.0), expected.value_or(0.0), 1e-9);
}

TEST(BrickRayCaster, FindsTheNearestOfAllBricks)
{
    forEachCar(
        [](const BrickModel& model)
        {
            const BrickRayCaster caster(model);
            RandomRays rays(model.getGrid(), 11);
            int hits = 0;
            for (int ray = 0; ray < 3000; ++ray)
            {
                const glm::dvec3 origin = rays.makeOrigin();
                const glm::dvec3 direction =
                    ray % 2 == 0 ? rays.makeDirection() : glm::normalize(rays.makeOrigin(0.0) - origin);
                const auto expected = askEveryBrick(model, origin, direction);
                ASSERT_NO_FATAL_FAILURE(expectSame(caster.findNearest(origin, direction, FAR), expected));
                if (!expected) continue;
                ASSERT_NO_FATAL_FAILURE(expectSame(caster.findNearest(origin, direction, *expected + 1e-6), expected));
                EXPECT_FALSE(caster.findNearest(origin, direction, *expected - 1e-6));
                ++hits;
            }
            EXPECT_GT(hits, 1000);
        });
}

TEST(BrickRayCaster, FollowsRaysAlongTheAxes)
{
    forEachCar(
        [](const BrickModel& model)
        {
            const BrickRayCaster caster(model);
            RandomRays rays(model.getGrid(), 12);
            for (int ray = 0; ray < 1000; ++ray)
            {
                const glm::dvec3 origin = rays.makeOrigin();
                const glm::dvec3 direction = rays.makeAxisDirection();
                const auto expected = askEveryBrick(model, origin, direction);
                ASSERT_NO_FATAL_FAILURE(expectSame(caster.findNearest(origin, direction, FAR), expected));
            }
        });
}

TEST(BrickRayCaster, StridesOverEmptyBlocks)
{
    // A few bricks, far apart, in a grid that ends inside a block.
    std::mt19937 engine(4);
    const auto model = createModel(glm::ivec3(61, 50, 43), [&](const glm::ivec3&) { return engine() % 400 == 0; });
    const BrickRayCaster caster(*model);
    RandomRays rays(model->getGrid(), 13);
    for (int ray = 0; ray < 5000; ++ray)
    {
        const glm::dvec3 origin = rays.makeOrigin(0.2);
        const glm::dvec3 direction = ray % 10 == 0 ? rays.makeAxisDirection() : rays.makeDirection();
        const auto expected = askEveryBrick(*model, origin, direction);
        ASSERT_NO_FATAL_FAILURE(expectSame(caster.findNearest(origin, direction, FAR), expected));
    }
}

TEST(BrickRayCaster, AStudIsHitFromAboveAndFromTheSideAndMissedBesideIt)
{
    const auto model = createModel(glm::ivec3(3), [](const glm::ivec3& cell) { return cell.z < 2; });
    const BrickRayCaster caster(*model);
    const double apothem = BrickDimensions::STUD_RADIUS * std::cos(PI / 16.0);
    const glm::dvec3 down(0.0, 0.0, -1.0);
    const glm::dvec3 right(1.0, 0.0, 0.0);

    EXPECT_NEAR(caster.findNearest({1.5, 1.5, 5.0}, down, FAR).value(), 3.0 - BrickDimensions::STUD_HEIGHT, 1e-12);
    EXPECT_NEAR(caster.findNearest({1.05, 1.5, 5.0}, down, FAR).value(), 3.0, 1e-12);
    // A corner of the stud lies on its u axis, +x here, and a flat side before the next one.
    EXPECT_NEAR(caster.findNearest({1.01, 1.5, 2.1}, right, FAR).value(), 0.49 - BrickDimensions::STUD_RADIUS, 1e-12);
    const glm::dvec3 toFlat(std::cos(PI / 16.0), std::sin(PI / 16.0), 0.0);
    EXPECT_NEAR(caster.findNearest(glm::dvec3(1.5, 1.5, 2.1) - 0.4 * toFlat, toFlat, FAR).value(), 0.4 - apothem,
                1e-12);
    EXPECT_FALSE(caster.findNearest({-1.0, 1.81, 2.1}, right, FAR));
    EXPECT_FALSE(caster.findNearest({-1.0, 1.5, 2.0 + BrickDimensions::STUD_HEIGHT + 1e-6}, right, FAR));
    // A ray that starts inside a stud hits it at once, as in a brick.
    EXPECT_EQ(caster.findNearest({1.5, 1.5, 2.1}, right, FAR), 0.0);
    EXPECT_EQ(caster.findNearest({1.5, 1.5, 1.1}, right, FAR), 0.0);
}

TEST(BrickRayCaster, StudsOnTheTopmostBricksStandOutOfTheGrid)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
    {
        BrickGrid grid;
        grid.upAxis = up;
        grid.dimensions = glm::ivec3(4);
        const auto model = createModel(grid, [](const glm::ivec3&) { return true; });
        const BrickRayCaster caster(*model);
        glm::dvec3 origin(0.5);
        origin[grid.getUpIndex()] = 4.1;
        origin.x = -1.0;
        EXPECT_NEAR(caster.findNearest(origin, {1.0, 0.0, 0.0}, FAR).value(), 1.5 - BrickDimensions::STUD_RADIUS, 1e-9);
    }
}

TEST(BrickRayCaster, AStudIsHitOnlyWhereTheCellAboveIsEmpty)
{
    // Two stacked bricks, a gap of one cell, and a third brick: studs in the gap and on top, none between or below.
    const auto model =
        createModel(glm::ivec3(1, 1, 5), [](const glm::ivec3& cell) { return cell.z != 0 && cell.z != 3; });
    const BrickRayCaster caster(*model);
    const auto isHitAt = [&](double height) { return caster.findNearest({-1.0, 0.5, height}, {1.0, 0.0, 0.0}, FAR); };
    EXPECT_FALSE(isHitAt(0.1));
    EXPECT_FALSE(isHitAt(0.9));
    EXPECT_NEAR(isHitAt(2.1).value(), 1.0, 1e-12);
    EXPECT_NEAR(isHitAt(3.1).value(), 1.5 - BrickDimensions::STUD_RADIUS, 1e-9);
    EXPECT_FALSE(isHitAt(3.9));
    EXPECT_NEAR(isHitAt(5.1).value(), 1.5 - BrickDimensions::STUD_RADIUS, 1e-9);
    EXPECT_FALSE(isHitAt(5.9));
}

TEST(BrickRayCaster, RaysFromFarOutsideMeetTheGridOrMissIt)
{
    const auto model = createModel(glm::ivec3(5), [](const glm::ivec3&) { return true; });
    const BrickRayCaster caster(*model);
    EXPECT_NEAR(caster.findNearest({-1e6, 2.5, 2.5}, {1.0, 0.0, 0.0}, FAR).value(), 1e6, 1e-6);
    EXPECT_NEAR(caster.findNearest({2.5, 1e6, 2.5}, {0.0, -1.0, 0.0}, FAR).value(), 1e6 - 5.0, 1e-6);
    EXPECT_FALSE(caster.findNearest({-1e6, 2.5, 2.5}, {-1.0, 0.0, 0.0}, FAR));
    EXPECT_FALSE(caster.findNearest({-1.0, 5.5, 2.5}, {1.0, 0.0, 0.0}, FAR));
    EXPECT_FALSE(caster.findNearest({-9.0, 2.5, 2.5}, {1.0, 0.0, 0.0}, 8.9));
    // On the faces of the grid: cells include their lower faces only.
    EXPECT_TRUE(caster.findNearest({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, FAR));
    EXPECT_FALSE(caster.findNearest({-1.0, 5.0, 2.5}, {1.0, 0.0, 0.0}, FAR));
    EXPECT_EQ(caster.findNearest({5.0, 2.5, 2.5}, {-1.0, 0.0, 0.0}, FAR), 0.0);
    EXPECT_FALSE(caster.findNearest({5.0, 2.5, 2.5}, {1.0, 0.0, 0.0}, FAR));
}

TEST(BrickRayCaster, NothingIsHitInAnEmptyModel)
{
    for (const glm::ivec3& dimensions : {glm::ivec3(0), glm::ivec3(9, 6, 7)})
    {
        const auto model = createModel(dimensions, [](const glm::ivec3&) { return false; });
        const BrickRayCaster caster(*model);
        RandomRays rays(model->getGrid(), 14);
        for (int ray = 0; ray < 100; ++ray)
            EXPECT_FALSE(
                caster.findNearest(2.0 * rays.makeOrigin() + 0.1, glm::normalize(glm::dvec3(1, ray, -3)), FAR));
        EXPECT_EQ(caster.sampleOcclusion(glm::dvec3(0.5), {0.0, 1.0, 0.0}, 5.0, 0.5, 16, 0).visibility, 1.0);
    }
}

TEST(BrickRayCaster, ConvertsFromModelUnits)
{
    const auto model = createCar(Proportions::PLATE, UpAxis::Z);
    const BrickGrid& grid = model->getGrid();
    const BrickRayCaster caster(*model);
    EXPECT_EQ(caster.getPitch(), grid.getPitch());
    const glm::dvec3 corner = grid.origin + grid.cellSize * glm::dvec3(3.0, 4.0, 5.0);
    const glm::dvec3 converted = caster.toCaster(osg::Vec3d(corner.x, corner.y, corner.z));
    EXPECT_NEAR(glm::distance(converted, glm::dvec3(3.0, 4.0, 2.0)), 0.0, 1e-9);
}

TEST(BrickRayCaster, AnOpenPlaneIsWhollyVisible)
{
    // The bottom of a slab: flat, without studs.
    const auto model = createModel(glm::ivec3(20, 20, 2), [](const glm::ivec3&) { return true; });
    const BrickRayCaster::Occlusion occlusion =
        BrickRayCaster(*model).sampleOcclusion({10.3, 9.8, 0.0}, {0.0, 0.0, -1.0}, 30.0, 0.5, 256, 1);
    EXPECT_EQ(occlusion.visibility, 1.0);
    EXPECT_NEAR(glm::distance(occlusion.bentNormal, glm::dvec3(0.0, 0.0, -1.0)), 0.0, 0.02);
}

TEST(BrickRayCaster, AnInnerEdgeOfTwoWallsHidesHalf)
{
    // Two walls, towards +x and +y, much higher and wider than the radius.
    const auto model =
        createModel(glm::ivec3(40, 40, 80), [](const glm::ivec3& cell) { return cell.x == 0 || cell.y == 0; });
    const BrickRayCaster caster(*model);
    const auto onX = caster.sampleOcclusion({1.0, 1.0005, 40.3}, {1.0, 0.0, 0.0}, 20.0, 0.01, 4096, 5);
    const auto onY = caster.sampleOcclusion({1.0005, 1.0, 40.3}, {0.0, 1.0, 0.0}, 20.0, 0.01, 4096, 6);
    EXPECT_NEAR(onX.visibility, 0.5, 0.01);
    EXPECT_NEAR(onY.visibility, 0.5, 0.01);
    // The cosine-weighted mean direction of a quarter sphere leans from the normal by atan(2 / pi), and the two walls'
    // bent normals lean towards each other by the same angle.
    const double lean = std::atan(2.0 / PI);
    EXPECT_NEAR(glm::distance(onX.bentNormal, glm::dvec3(std::cos(lean), std::sin(lean), 0.0)), 0.0, 0.02);
    EXPECT_NEAR(glm::distance(onY.bentNormal, glm::dvec3(std::sin(lean), std::cos(lean), 0.0)), 0.0, 0.02);
    const glm::dvec3 between = glm::normalize(onX.bentNormal + onY.bentNormal);
    EXPECT_NEAR(glm::distance(between, glm::normalize(glm::dvec3(1.0, 1.0, 0.0))), 0.0, 0.01);
}

TEST(BrickRayCaster, VisibilityFollowsTheFormFactorOfAWall)
{
    // A long wall at distance d that rises to height h above the floor hides (1 - d / sqrt(d^2 + h^2)) / 2.
    const auto model =
        createModel(glm::ivec3(8, 400, 8), [](const glm::ivec3& cell) { return cell.x == 0 || cell.z == 7; });
    const BrickRayCaster caster(*model);
    for (const double distance : {0.5, 1.7, 4.0})
    {
        // On the underside of the ceiling, where no studs are.
        const glm::dvec3 point(1.0 + distance, 200.4, 7.0);
        const auto occlusion = caster.sampleOcclusion(point, {0.0, 0.0, -1.0}, 1000.0, 1e-9, 4096, 9);
        const double expected = 0.5 * (1.0 + distance / std::hypot(distance, 7.0));
        EXPECT_NEAR(occlusion.visibility, expected, 0.01);
    }
}

TEST(BrickRayCaster, AClosedHoleIsDark)
{
    const auto model = createModel(glm::ivec3(5), [](const glm::ivec3& cell) { return cell != glm::ivec3(2); });
    const BrickRayCaster caster(*model);
    const glm::dvec3 normal(1.0, 0.0, 0.0);
    const auto occlusion = caster.sampleOcclusion({2.0, 2.5, 2.6}, normal, 10.0, 0.5, 64, 3);
    EXPECT_EQ(occlusion.visibility, 0.0);
    EXPECT_EQ(occlusion.bentNormal, normal);
}

TEST(BrickRayCaster, HitsFadeTowardsTheRadius)
{
    // From the underside of a ceiling down to a floor two cells below.
    const auto model = createModel(glm::ivec3(101, 101, 4), [](const glm::ivec3& cell) { return cell.z % 3 == 0; });
    const BrickRayCaster caster(*model);
    const glm::dvec3 point(50.02, 50.03, 3.0);
    const glm::dvec3 normal(0.0, 0.0, -1.0);
    EXPECT_EQ(caster.sampleOcclusion(point, normal, 1.7, 0.5, 256, 2).visibility, 1.0);
    const auto visibilityOf = [&](double radius, double falloff)
    { return caster.sampleOcclusion(point, normal, radius, falloff, 256, 2).visibility; };
    EXPECT_GT(visibilityOf(3.0, 0.5), visibilityOf(6.0, 0.5));
    EXPECT_GT(visibilityOf(6.0, 0.5), visibilityOf(40.0, 0.5));
    EXPECT_GT(visibilityOf(6.0, 1.0), visibilityOf(6.0, 0.5));
    EXPECT_LT(visibilityOf(40.0, 0.01), 0.01);
}

TEST(BrickRayCaster, EqualSeedsGiveEqualResultsAndOtherSeedsDiffer)
{
    const auto model = createCar(Proportions::BRICK, UpAxis::Z);
    const BrickRayCaster caster(*model);
    const auto sample = [&](std::uint32_t seed) {
        return caster.sampleOcclusion({7.5, 2.0, 0.0}, {0.0, 0.0, -1.0}, 12.0, 1.0, 32, seed);
    };
    const auto first = sample(7);
    const auto again = BrickRayCaster(*model).sampleOcclusion({7.5, 2.0, 0.0}, {0.0, 0.0, -1.0}, 12.0, 1.0, 32, 7);
    EXPECT_EQ(first.visibility, again.visibility);
    EXPECT_EQ(first.bentNormal, again.bentNormal);
    EXPECT_NE(first.bentNormal, sample(8).bentNormal);
    EXPECT_NE(first.bentNormal, sample(0).bentNormal);
}

TEST(BrickRayCaster, EverySeedAndNormalSamplesTheWeightedHemisphere)
{
    const auto model = createModel(glm::ivec3(1), [](const glm::ivec3&) { return false; });
    const BrickRayCaster caster(*model);
    RandomRays rays(model->getGrid(), 15);
    for (std::uint32_t seed = 0; seed < 200; ++seed)
    {
        const glm::dvec3 normal = seed < 50 ? rays.makeAxisDirection() : rays.makeDirection();
        const auto occlusion = caster.sampleOcclusion(glm::dvec3(0.0), normal, 1.0, 1.0, 64, seed);
        EXPECT_EQ(occlusion.visibility, 1.0);
        EXPECT_NEAR(glm::length(occlusion.bentNormal), 1.0, 1e-12);
        EXPECT_NEAR(glm::distance(occlusion.bentNormal, normal), 0.0, 0.05);
    }
}

TEST(BrickRayCaster, MemoryFollowsTheBricksNotTheGrid)
{
    BrickGrid grid;
    grid.dimensions = GridLimits::getLargest(grid.getUpIndex());
    Brick brick;
    brick.cell = {1023, 1023, 2559};
    const osg::ref_ptr<const BrickModel> model = BrickModel::create(grid, {Brick(), brick});
    const std::size_t before = test::getHeapSize();
    const BrickRayCaster caster(*model);
    EXPECT_LT(test::getHeapSize() - before, test::HEAP_OF_FEW_BRICKS);
    EXPECT_DOUBLE_EQ(caster.findNearest({1023.5, 0.0, 2559.5}, {0.0, 1.0, 0.0}, FAR).value(), 1023.0);
    EXPECT_FALSE(caster.findNearest({1022.5, 0.0, 2559.5}, {0.0, 1.0, 0.0}, FAR));
}

} // namespace

} // namespace osgLego
