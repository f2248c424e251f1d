#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A coarse division of a grid, of at most 32 blocks along each side, that tells which of its surfaces can be seen from
 * outside.
 *
 * Usage:
 *
 *     OpenBlocks blocks(grid.dimensions);
 *     for (const glm::vec3& place : places)
 *         blocks.cover(place);
 *     blocks.findOpen();
 *     if (blocks.isBesideOpen(place)) ... // it is visible
 *
 * One thread at a time.
 */
class OpenBlocks
{
public:
    /** @param size of the grid, in cells: 1 or more along each axis. */
    explicit OpenBlocks(const glm::ivec3& size);

    /** Mark the block of a place on a surface. @param place 0 to the size of the grid, in cells. */
    void cover(const glm::vec3& place);
    /** Find the blocks that are connected to the outside through blocks without a surface. */
    void findOpen();
    /** Whether the block of a place, or one of its 26 neighbours, is open or outside the grid. */
    bool isBesideOpen(const glm::vec3& place) const;

private:
    enum class State : unsigned char
    {
        EMPTY,
        COVERED,
        OPEN
    };

    glm::ivec3 blockAt(const glm::vec3& place) const;
    // The blocks of the grid are surrounded by a layer of blocks outside, from -1 to the number of blocks.
    std::size_t indexOf(const glm::ivec3& block) const;

    float _width; // of a block, in cells
    glm::ivec3 _counts;
    std::vector<State> _states;
};

} // namespace osgLego
