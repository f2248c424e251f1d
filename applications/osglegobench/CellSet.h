#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A set of cells of a grid, one bit per cell of the grid. */
class CellSet
{
public:
    explicit CellSet(const glm::ivec3& dimensions) :
        _dimensions(dimensions), _bits(static_cast<std::size_t>(dimensions.x) * static_cast<std::size_t>(dimensions.y) *
                                       static_cast<std::size_t>(dimensions.z))
    {
    }

    bool isInside(const glm::ivec3& cell) const
    {
        return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < _dimensions.x && cell.y < _dimensions.y &&
               cell.z < _dimensions.z;
    }

    /** False for cells outside the grid. */
    bool contains(const glm::ivec3& cell) const { return isInside(cell) && _bits[numberOf(cell)]; }

    /** Add a cell inside the grid. @return whether it is new. */
    bool insert(const glm::ivec3& cell)
    {
        auto bit = _bits[numberOf(cell)];
        if (bit) return false;
        bit = true;
        ++_size;
        return true;
    }

    std::size_t getSize() const { return _size; }
    const glm::ivec3& getDimensions() const { return _dimensions; }

private:
    std::size_t numberOf(const glm::ivec3& cell) const
    {
        const auto row = static_cast<std::size_t>(cell.y) +
                         static_cast<std::size_t>(_dimensions.y) * static_cast<std::size_t>(cell.z);
        return static_cast<std::size_t>(cell.x) + static_cast<std::size_t>(_dimensions.x) * row;
    }

    glm::ivec3 _dimensions;
    std::vector<bool> _bits;
    std::size_t _size = 0;
};

} // namespace osgLego
