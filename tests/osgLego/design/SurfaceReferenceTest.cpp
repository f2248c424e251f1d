#include <osgLego/design/SurfaceReference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr std::array<std::uint8_t, 3> RED{200, 0, 0};
constexpr std::array<std::uint8_t, 3> BLUE{0, 0, 200};

/** The cells of a cube of 2 units, from the origin on, that a predicate selects. @param resolution cells along it. */
osg::ref_ptr<const BrickModel> makeCube(int resolution, const std::array<std::uint8_t, 3>& color,
                                        const std::function<bool(const glm::ivec3&)>& isCovered)
{
    BrickGrid grid;
    grid.cellSize = glm::dvec3(2.0 / resolution);
    grid.dimensions = glm::ivec3(resolution);
    std::vector<Brick> bricks;
    for (int z = 0; z < resolution; ++z)
        for (int y = 0; y < resolution; ++y)
            for (int x = 0; x < resolution; ++x)
                if (isCovered({x, y, z}))
                {
                    Brick brick;
                    brick.cell = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                  static_cast<std::uint16_t>(z)};
                    brick.color = color;
                    bricks.push_back(brick);
                }
    return BrickModel::create(grid, std::move(bricks));
}

/** The outermost cells of a cube. */
std::function<bool(const glm::ivec3&)> isOnSurface(int resolution)
{
    return [resolution](const glm::ivec3& cell)
    {
        for (int axis = 0; axis < 3; ++axis)
            if (cell[axis] == 0 || cell[axis] == resolution - 1) return true;
        return false;
    };
}

constexpr int FINE = 80;
constexpr double FINE_CELL = 2.0 / FINE;

TEST(SurfaceReference, ASurfaceOnTheOuterSidesHasNoDistance)
{
    const SurfaceReference reference(*makeCube(FINE, RED, isOnSurface(FINE)));
    const SurfaceDifference same = reference.compare(*makeCube(8, RED, [](const glm::ivec3&) { return true; }));
    EXPECT_LE(same.distance, FINE_CELL);
    EXPECT_NEAR(same.color, 0.0, 1e-9);
}

TEST(SurfaceReference, CavitiesDoNotCount)
{
    const SurfaceReference reference(*makeCube(FINE, RED, isOnSurface(FINE)));
    // The inner sides of the hollow cube are 0.25 away from the surface.
    const SurfaceDifference hollow = reference.compare(*makeCube(8, RED, isOnSurface(8)));
    EXPECT_LE(hollow.distance, FINE_CELL);
}

TEST(SurfaceReference, TheDistanceIsTheRootOfTheMeanSquare)
{
    // The lower half of the cube: its top, a third of the area of its sides, is 1 away from the surface in the middle.
    const SurfaceReference reference(*makeCube(FINE, RED, isOnSurface(FINE)));
    const osg::ref_ptr<const BrickModel> half = makeCube(40, RED, [](const glm::ivec3& cell) { return cell.z < 20; });
    // On the top, the distance to the nearest side is that to the nearest edge of a square of 2 x 2: its mean square is
    // 1/6. The area of the top is 4, that of the rest 12.
    EXPECT_NEAR(reference.compare(*half).distance, std::sqrt(4.0 / 6.0 / 16.0), FINE_CELL);
}

TEST(SurfaceReference, TheSurfaceInAGapThatBricksCloseIsLost)
{
    // Two boxes of 0.8 x 2 x 2, 0.4 apart.
    const auto isOnBox = [](const glm::ivec3& cell)
    {
        constexpr int END = FINE * 2 / 5;
        const int x = std::min(cell.x, FINE - 1 - cell.x);
        return x < END && (x == 0 || x == END - 1 || isOnSurface(FINE)(cell));
    };
    const SurfaceReference reference(*makeCube(FINE, RED, isOnBox));
    const auto isInBox = [](const glm::ivec3& cell) { return cell.x < 4 || cell.x >= 6; };
    EXPECT_EQ(reference.compare(*makeCube(10, RED, isInBox)).lost, 0.0);
    const SurfaceDifference closed = reference.compare(*makeCube(10, RED, [](const glm::ivec3&) { return true; }));
    // Lost is what is more than 0.25 from the edges of the two squares in the gap.
    EXPECT_NEAR(closed.lost, 2.0 * 1.5 * 1.5 / 28.8, 0.02);
    EXPECT_LE(closed.distance, 0.2) << "the bricks in the gap are near the surface";
}

TEST(SurfaceReference, TheSurfaceInAHairlineGapIsNotLost)
{
    // Two boxes that are two fine cells apart.
    const auto isOnBox = [](const glm::ivec3& cell)
    {
        constexpr int END = FINE / 2 - 1;
        const int x = std::min(cell.x, FINE - 1 - cell.x);
        return x < END && (x == 0 || x == END - 1 || isOnSurface(FINE)(cell));
    };
    const SurfaceReference reference(*makeCube(FINE, RED, isOnBox));
    EXPECT_EQ(reference.compare(*makeCube(10, RED, [](const glm::ivec3&) { return true; })).lost, 0.0);
}

TEST(SurfaceReference, ASurfaceThatIsNotSeenFromOutsideIsNotLost)
{
    // A cube in a cube.
    const auto isOnEither = [](const glm::ivec3& cell)
    {
        constexpr int MARGIN = FINE / 4;
        const glm::ivec3 inner = cell - MARGIN;
        const bool isInside = glm::all(glm::greaterThanEqual(inner, glm::ivec3(0))) &&
                              glm::all(glm::lessThan(inner, glm::ivec3(FINE - 2 * MARGIN)));
        return isOnSurface(FINE)(cell) || (isInside && isOnSurface(FINE - 2 * MARGIN)(inner));
    };
    const SurfaceReference reference(*makeCube(FINE, RED, isOnEither));
    EXPECT_EQ(reference.compare(*makeCube(10, RED, [](const glm::ivec3&) { return true; })).lost, 0.0);
}

TEST(SurfaceReference, TheColorIsThatOfTheNearestPlace)
{
    const SurfaceReference reference(*makeCube(FINE, BLUE, isOnSurface(FINE)));
    const SurfaceDifference red = reference.compare(*makeCube(8, RED, [](const glm::ivec3&) { return true; }));
    EXPECT_GT(red.color, 30.0);
    const osg::ref_ptr<const BrickModel> model = makeCube(8, BLUE, [](const glm::ivec3&) { return true; });
    std::vector<Brick> bricks = model->getBricks();
    for (Brick& brick : bricks)
        if (brick.cell[0] < 4) brick.color = RED;
    const osg::ref_ptr<const BrickModel> half = BrickModel::createComplete(model->getGrid(), std::move(bricks));
    EXPECT_NEAR(reference.compare(*half).color, 0.5 * red.color, 1e-9);
}

} // namespace

} // namespace osgLego
