#include <osgLego/BrickGrid.h>

#include <Settings.h>

#include <cmath>
#include <limits>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

LegoSettings settingsOf(unsigned int resolution, Proportions proportions = Proportions::CUBE, UpAxis up = UpAxis::Z)
{
    LegoSettings settings;
    settings.grid.resolution = resolution;
    settings.grid.proportions = proportions;
    settings.grid.upAxis = up;
    return settings;
}

TEST(BrickGrid, TheLongestSideIsNWidthsOfACellLongInAllProportions)
{
    for (const osg::Vec3d& size :
         {osg::Vec3d(3, 1, 2), osg::Vec3d(1, 0.7, 0.1), osg::Vec3d(0.3, 0.2, 5), osg::Vec3d(1, 1, 1)})
        for (const unsigned int resolution : {1u, 7u, 64u, 1000u, 1024u})
            for (const Proportions proportions : {Proportions::CUBE, Proportions::BRICK, Proportions::PLATE})
            {
                const osg::Vec3d corner(-12.3, 4.5, 100.1);
                const BrickGrid grid = BrickGrid::fit({corner, corner + size}, settingsOf(resolution, proportions));
                const int longest = size.z() > size.x() && size.z() > size.y() ? 2 : size.y() > size.x() ? 1 : 0;
                EXPECT_NEAR(grid.getPitch() * resolution, size[longest], 1e-12);
                // Whole layers, so a part of one may be beyond the top.
                const double length = grid.dimensions[longest] * grid.cellSize[longest];
                EXPECT_GE(length, size[longest] - 1e-5 * grid.cellSize[longest]);
                EXPECT_LT(length, size[longest] + grid.cellSize[longest]);
                const int layers = static_cast<int>(resolution);
                EXPECT_TRUE(grid.dimensions[longest] == layers || (longest == 2 && proportions != Proportions::CUBE));
            }
}

TEST(BrickGrid, CellsHaveTheHeightOfTheirKindAlongTheUpAxis)
{
    const osg::BoundingBoxd bounds(0, 0, 0, 4, 2, 2);
    const BrickGrid brick = BrickGrid::fit(bounds, settingsOf(40, Proportions::BRICK));
    EXPECT_NEAR(brick.cellSize.z / brick.cellSize.x, 1.2, 1e-12);
    EXPECT_EQ(brick.dimensions, glm::ivec3(40, 20, 17));
    const BrickGrid plate = BrickGrid::fit(bounds, settingsOf(40, Proportions::PLATE, UpAxis::Y));
    EXPECT_NEAR(plate.cellSize.y / plate.cellSize.x, 0.4, 1e-12);
    EXPECT_EQ(plate.dimensions, glm::ivec3(40, 50, 20));
}

TEST(BrickGrid, SpareSpaceIsSplitBetweenTheSidesAndLiesOnTop)
{
    const BrickGrid grid = BrickGrid::fit({0, 0, 0, 10, 2.5, 3.5}, settingsOf(10));
    EXPECT_EQ(grid.dimensions, glm::ivec3(10, 3, 4));
    EXPECT_DOUBLE_EQ(grid.origin.x, 0.0);
    EXPECT_DOUBLE_EQ(grid.origin.y, -0.25);
    EXPECT_DOUBLE_EQ(grid.origin.z, 0.0);
}

TEST(BrickGrid, TheGridContainsTheBounds)
{
    const osg::BoundingBoxd bounds(-1.37, 0.2, 5.0, 0.91, 1.77, 5.6);
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
        for (unsigned int resolution = 1; resolution < 200; ++resolution)
        {
            const BrickGrid grid = BrickGrid::fit(bounds, settingsOf(resolution, Proportions::BRICK, up));
            const glm::dvec3 low = grid.toCells(bounds._min);
            const glm::dvec3 high = grid.toCells(bounds._max);
            for (int axis = 0; axis < 3; ++axis)
            {
                EXPECT_GE(low[axis], -1e-9);
                EXPECT_LE(high[axis], grid.dimensions[axis] + 1e-6);
            }
        }
}

TEST(BrickGrid, TheBoundsIncludeTheStuds)
{
    const BrickGrid grid = BrickGrid::fit({0, 0, 0, 10, 10, 5}, settingsOf(10, Proportions::PLATE));
    EXPECT_NEAR(grid.getBrickBounds().zMax(), 0.4 * grid.dimensions.z + 0.2125, 1e-12);
    const BrickGrid upright = BrickGrid::fit({0, 0, 0, 10, 10, 5}, settingsOf(10, Proportions::CUBE, UpAxis::Y));
    EXPECT_NEAR(upright.getBrickBounds().yMax(), 10.2125, 1e-12);
    EXPECT_NEAR(upright.getBrickBounds().zMax(), 5.0, 1e-12);
}

TEST(BrickGrid, AFlatMeshHasOneLayer)
{
    EXPECT_EQ(BrickGrid::fit({0, 0, 3, 4, 2, 3}, settingsOf(8)).dimensions, glm::ivec3(8, 4, 1));
}

TEST(BrickGrid, EmptyAndInfiniteBoundsHaveNoCells)
{
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(BrickGrid::fit({}, settingsOf(8)).getNumCells(), 0u);
    EXPECT_EQ(BrickGrid::fit({1, 1, 1, 1, 1, 1}, settingsOf(8)).getNumCells(), 0u);
    EXPECT_EQ(BrickGrid::fit({0, 0, 0, infinity, 1, 1}, settingsOf(8)).getNumCells(), 0u);
}

TEST(BrickGrid, CellsOfAGivenPitchAreThoseThatTheBoundsReachInto)
{
    const BrickGrid grid =
        BrickGrid::fit({-0.9, 0.1, 2.6, 1.1, 0.4, 3.9}, test::parseSettings("cell=0.5,proportions=brick"));
    EXPECT_EQ(grid.cellSize, glm::dvec3(0.5, 0.5, 0.6));
    EXPECT_LT(glm::distance(grid.origin, glm::dvec3(-1.0, 0.0, 2.4)), 1e-12);
    EXPECT_EQ(grid.dimensions, glm::ivec3(5, 1, 3));
    const BrickGrid moved =
        BrickGrid::fit({-0.9, 0.1, 2.6, 1.1, 0.4, 3.9}, test::parseSettings("cell=0.5,origin=0.2:0.3:-7.25"));
    EXPECT_LT(glm::distance(moved.origin, glm::dvec3(-1.3, -0.2, 2.25)), 1e-12);
    EXPECT_EQ(moved.dimensions, glm::ivec3(5, 2, 4));
}

TEST(BrickGrid, ASurfaceBetweenTwoCellsOfAGivenPitchBelongsToTheUpperOne)
{
    EXPECT_EQ(BrickGrid::fit({0, 0, 0, 4, 3, 3.9}, test::parseSettings("cell=1")).dimensions, glm::ivec3(5, 4, 4));
    // 0.3 / 0.1 is less than 3, but not in single precision.
    EXPECT_EQ(BrickGrid::fit({0, 0, 0, 0.3, 0.3, 0.3}, test::parseSettings("cell=0.1")).dimensions, glm::ivec3(4));
    EXPECT_EQ(BrickGrid::fit({0.3, 0.3, 0.3, 0.35, 0.35, 0.35}, test::parseSettings("cell=0.1")).dimensions,
              glm::ivec3(1));
}

TEST(BrickGrid, AnOriginAndASizeNeedNotContainTheBounds)
{
    const BrickGrid grid =
        BrickGrid::fit({0, 0, 0, 4, 4, 4}, test::parseSettings("cell=0.5,origin=10:20:30,size=3:4:5,up=y"));
    EXPECT_EQ(grid.origin, glm::dvec3(10, 20, 30));
    EXPECT_EQ(grid.dimensions, glm::ivec3(3, 4, 5));
    EXPECT_EQ(grid.upAxis, UpAxis::Y);
}

TEST(BrickGrid, TooManyCellsAreAnObstacle)
{
    const osg::BoundingBoxd bounds(0, 0, 0, 100, 2, 2500.5);
    EXPECT_EQ(BrickGrid::findObstacle(bounds, test::parseSettings("cell=1")), "");
    EXPECT_EQ(BrickGrid::fit(bounds, test::parseSettings("cell=1")).dimensions, glm::ivec3(101, 3, 2501));
    const std::string limits = ", by a larger cell, or by origin and size that select a part";
    EXPECT_EQ(BrickGrid::findObstacle(bounds, test::parseSettings("cell=0.9,up=y")),
              "the model reaches into 112 x 3 x 2779 cells; expected at most 1024 x 2560 x 1024" + limits);
    EXPECT_EQ(BrickGrid::fit(bounds, test::parseSettings("cell=0.9,up=y")).getNumCells(), 0u);
    EXPECT_NE(BrickGrid::findObstacle(bounds, test::parseSettings("cell=1e-9")), "");
    EXPECT_EQ(BrickGrid::findObstacle(bounds, test::parseSettings("cell=1e-9,origin=0:0:0,size=1:1:1")), "");
    EXPECT_NE(BrickGrid::findObstacle(bounds, test::parseSettings("cell=1,origin=1e12:0:0")), "")
        << "too far for double precision";
    EXPECT_NE(BrickGrid::findObstacle(bounds, test::parseSettings("cell=1,origin=0:-1e12:0")), "");
    EXPECT_EQ(BrickGrid::findObstacle(bounds, test::parseSettings("64")), "");
    EXPECT_EQ(BrickGrid::findObstacle({}, test::parseSettings("cell=1")), "");
}

TEST(BrickGrid, CellsToModelIsTheInverseOfToCells)
{
    const BrickGrid grid = BrickGrid::fit({-3, 2, 1, 5, 4, 9}, settingsOf(33, Proportions::BRICK));
    const osg::Vec3d point(0.3, 3.1, 7.7);
    const glm::dvec3 cells = grid.toCells(point);
    const osg::Vec3d back = osg::Vec3d(cells.x, cells.y, cells.z) * grid.getCellsToModel();
    EXPECT_NEAR((back - point).length(), 0.0, 1e-12);
}

} // namespace

} // namespace osgLego
