#pragma once

#include <osgLego/Part.h>

#include <cstdint>
#include <span>
#include <unordered_map>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Records which cells of a grid are taken, in blocks, so that parts far from each other need no memory for the cells
 * between them. */
class TakenCells
{
public:
    /** Whether two parts share a cell. */
    static bool overlap(std::span<const Part> parts);

    /** Take the cells of a part. @return false if one of them is taken. */
    bool take(const Part& part);

private:
    static constexpr int SIDE = 4; // a block has 64 cells, the bits of one number

    bool take(const glm::ivec3& cell);

    std::unordered_map<std::uint64_t, std::uint64_t> _blocks;
};

} // namespace osgLego
