#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/BrickPoints.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

/** The occupancy of a grid of bricks, in voxels: blocks of cells of about the same width, depth and height. A margin
 * around the grid is wide enough for rays of a given length from every voxel.
 *
 * Voxels are counted from 0, with a border of one voxel around those of the grid. May be called from any thread.
 */
class VoxelGrid
{
public:
    /** Voxels around the grid, so that samples at its border are interpolated, too. */
    static constexpr int BORDER = 1;

    /** The longest side of a grid, in pitches. */
    static double getLongestSide(const BrickGrid& grid);

    /** No voxel is covered yet, and no memory taken.
     * @param width of a voxel, in pitches; 0 for voxels of one cell. @param reach the length of rays, in pitches. */
    VoxelGrid(const BrickGrid& grid, double width, double reach);

    /** Cover the voxels of bricks. To be called once, before any place is asked for its cover.
     * @param points the visible bricks. */
    void cover(std::span<const BrickPoint> points);

    /** The number of cells in a voxel, along each axis. */
    const glm::ivec3& getCellsPerVoxel() const { return _cellsPerVoxel; }
    /** The edges of a voxel, in pitches. */
    const glm::dvec3& getExtent() const { return _extent; }
    /** The number of voxels along each axis, with the border. */
    const glm::ivec3& getSize() const { return _size; }

    /** Whether a voxel is one of the grid or its border. */
    bool contains(const glm::ivec3& voxel) const
    {
        return glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) && glm::all(glm::lessThan(voxel, _size));
    }

    /** The number of voxels in memory, with the margin. */
    std::size_t getNumVoxels() const { return _numVoxels; }
    /** The distance in memory between voxels that are `step` apart. */
    std::ptrdiff_t getOffset(const glm::ivec3& step) const
    {
        return step.x + step.y * _strides.y + step.z * _strides.z;
    }
    /** The place of a voxel in memory. @param voxel no farther outside than `reach`. */
    std::size_t getPlace(const glm::ivec3& voxel) const { return static_cast<std::size_t>(getOffset(voxel + _margin)); }
    /** Whether the voxel at a place has bricks: a single cell, or enough for a surface through its middle. */
    bool isCovered(std::size_t place) const { return _covered[place] != 0; }
    /** Those of all voxels, by place. */
    const std::uint8_t* getCovered() const { return _covered.data(); }

private:
    glm::ivec3 _cellsPerVoxel{1};
    glm::dvec3 _extent{1.0};
    glm::ivec3 _size{0};
    glm::ivec3 _margin{0};
    glm::vec<3, std::ptrdiff_t> _strides{0};
    std::size_t _numVoxels = 0;
    std::vector<std::uint8_t> _covered; // 1 for voxels with bricks
};

} // namespace osgLego
