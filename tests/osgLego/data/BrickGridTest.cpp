#include <osgLego/BrickGrid.h>

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
    settings.resolution = resolution;
    settings.proportions = proportions;
    settings.upAxis = up;
    return settings;
}

TEST(BrickGrid, TheLongestSideHasExactlyNCells)
{
    for (const osg::Vec3d& size :
         {osg::Vec3d(3, 1, 2), osg::Vec3d(1, 0.7, 0.1), osg::Vec3d(0.3, 0.2, 5), osg::Vec3d(1, 1, 1)})
        for (const unsigned int resolution : {1u, 7u, 64u, 1000u, 1024u})
            for (const Proportions proportions : {Proportions::CUBE, Proportions::BRICK, Proportions::PLATE})
            {
                const osg::Vec3d corner(-12.3, 4.5, 100.1);
                const BrickGrid grid = BrickGrid::fit({corner, corner + size}, settingsOf(resolution, proportions));
                const int longest = size.z() > size.x() && size.z() > size.y() ? 2 : size.y() > size.x() ? 1 : 0;
                EXPECT_EQ(grid.dimensions[longest], static_cast<int>(resolution));
                EXPECT_NEAR(grid.dimensions[longest] * grid.cellSize[longest], size[longest], 1e-12);
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
