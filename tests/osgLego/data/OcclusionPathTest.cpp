#include <osgLego/data/OcclusionPath.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** Whether a voxel is outside of a grid, or in its border, on a side from which a ray does not return.
 * @param direction of the ray. */
bool isOutside(const VoxelGrid& grid, const glm::ivec3& voxel, const glm::vec3& direction)
{
    for (int axis = 0; axis < 3; ++axis)
        if ((voxel[axis] < VoxelGrid::BORDER && direction[axis] < 0.0f) ||
            (voxel[axis] >= grid.getSize()[axis] - VoxelGrid::BORDER && direction[axis] >= 0.0f))
            return true;
    return false;
}

TEST(OcclusionPath, CountsTheStepsUntilItLeavesTheGridForGood)
{
    BrickGrid bricks;
    bricks.dimensions = {9, 4, 7};
    bricks.cellSize = {1.0, 1.0, 0.4};
    constexpr double REACH = 6.0;
    const VoxelGrid grid(bricks, 0.0, REACH);
    std::vector<glm::dvec3> directions = createSphere(40);
    directions.insert(directions.end(), {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}});
    int numShort = 0;
    for (const glm::dvec3& direction : directions)
    {
        const OcclusionPath path(grid, 0.5 * grid.getExtent(), direction, REACH);
        for (int z = 0; z < grid.getSize().z; ++z)
            for (int y = 0; y < grid.getSize().y; ++y)
                for (int x = 0; x < grid.getSize().x; ++x)
                {
                    const glm::ivec3 voxel(x, y, z);
                    std::size_t expected = 0;
                    while (expected < path.getSteps().size() &&
                           !isOutside(grid, voxel + path.getSteps()[expected].voxel, path.getDirection()))
                        ++expected;
                    ASSERT_EQ(path.countStepsInside(voxel), expected) << x << ' ' << y << ' ' << z;
                    if (expected < path.getSteps().size()) ++numShort;
                }
    }
    EXPECT_GT(numShort, 1000);
}

} // namespace

} // namespace osgLego
