#pragma once

#include <cstddef>
#include <string>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

/** The limits of every grid, whether settings, stored bricks or a file of LDraw describe it.
 *
 * Usage:
 *
 *     if (!osgLego::GridLimits::contain(cells, upIndex))
 *         error = "expected at most " + osgLego::GridLimits::describe(upIndex) + " cells";
 *
 * Plain values without GL; every function may be called from any thread.
 */
struct GridLimits
{
    /** The most cells along each horizontal axis. */
    static constexpr int MOST_CELLS = 1024;
    /** The most cells along the up axis: a plate is 0.4 as high as wide. */
    static constexpr int MOST_LAYERS = MOST_CELLS * 5 / 2;
    /** The most cells of a filled model, and of stored bricks: a fortieth of the largest grid, so that a model of 1024
     * x 1024 cells may be 64 layers high. Each takes 10 bytes, and 36 while parts are read. */
    static constexpr std::size_t MOST_BRICKS = std::size_t(MOST_CELLS) * MOST_CELLS * MOST_LAYERS / 40;
    /** The longest edge of a cell divided by its shortest one. */
    static constexpr double MOST_STRETCH = 4.0;

    /** The largest grid. @param upIndex see BrickGrid::getUpIndex(). */
    static glm::ivec3 getLargest(int upIndex)
    {
        glm::ivec3 largest(MOST_CELLS);
        largest[upIndex] = MOST_LAYERS;
        return largest;
    }

    /** Whether a grid may have so many cells along its axes. */
    static bool contain(const glm::dvec3& cells, int upIndex)
    {
        return glm::all(glm::lessThanEqual(cells, glm::dvec3(getLargest(upIndex))));
    }

    /** The largest grid as text, such as `1024 x 1024 x 2560`. */
    static std::string describe(int upIndex)
    {
        const glm::ivec3 largest = getLargest(upIndex);
        return std::to_string(largest.x) + " x " + std::to_string(largest.y) + " x " + std::to_string(largest.z);
    }
};

} // namespace osgLego
