#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/BrickModel.h>
#include <osgLego/data/BrickPoints.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/ref_ptr>

namespace osgLego
{

/** Gathers the cells that a contender finds, on the CPU, in any order, possibly with duplicates.
 *
 * One bit per cell records the cells found, so that neither gathering nor the search for open sides visits the whole
 * grid; only clearing the bits does. */
class GatheredCells
{
public:
    /** Clear the set, for a grid with the given number of cells along each axis. */
    void reset(const glm::ivec3& dimensions);

    /** Add a cell. If it is added again, it keeps its first colour. @param color as in a BrickPoint. */
    void add(const glm::ivec3& cell, std::uint32_t color)
    {
        const std::size_t number = numberOf(cell);
        std::uint64_t& word = _words[number / 64];
        const std::uint64_t bit = std::uint64_t(1) << number % 64;
        if (word & bit) return;
        word |= bit;
        _bricks.push_back(
            {static_cast<std::uint32_t>(cell.x | cell.y << 16), static_cast<std::uint32_t>(cell.z), color});
    }

    /** The cells with an empty neighbour, in the order they were added. */
    const std::vector<BrickPoint>& findVisible();

    /** All cells, without open sides. */
    const std::vector<BrickPoint>& getBricks() const { return _bricks; }

private:
    // A border of empty cells around the grid, so that every cell has neighbours.
    std::size_t numberOf(const glm::ivec3& cell) const
    {
        return static_cast<std::size_t>(cell.x + 1) + static_cast<std::size_t>(cell.y + 1) * _rowLength +
               static_cast<std::size_t>(cell.z + 1) * _layerLength;
    }
    bool isEmpty(std::size_t number) const { return !(_words[number / 64] >> number % 64 & 1); }
    std::uint32_t findOpenSides(const BrickPoint& brick) const;

    std::size_t _rowLength = 0;
    std::size_t _layerLength = 0;
    std::vector<std::uint64_t> _words;
    std::vector<BrickPoint> _bricks;
    std::vector<BrickPoint> _visible;
};

/** Convert points to the bricks of a model; their open sides are computed again. */
osg::ref_ptr<const BrickModel> createModel(const BrickGrid& grid, const std::vector<BrickPoint>& points);

} // namespace osgLego
