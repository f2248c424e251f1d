#pragma once

#include <osgLego/data/CellKeys.h>
#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/stability/JointGraph.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The parts of a layout that can't be placed from bottom to top: no upward path of joints from the lowest layer
 * reaches them.
 *
 * Usage:
 *
 *     HangingParts hanging(layout.parts);
 *     for (const std::vector<std::uint32_t>& group : hanging.getGroups()) ...
 *     hanging.supportAt({x, y, z}); // as if a column stood below that cell
 *
 * One thread. */
class HangingParts
{
public:
    explicit HangingParts(const LaidParts& parts);

    /** The hanging parts that joints connect to each other, the largest group first.
     * @return indices of parts, in ascending order. */
    std::vector<std::vector<std::uint32_t>> getGroups() const;

    /** The parts that would hang no longer if one of them were supported from below: itself, and those above. */
    std::vector<std::uint32_t> findAbove(std::uint32_t part) const;

    /** Whether a hanging part covers a cell. */
    bool isAt(const glm::ivec3& cell) const;

    /** Support the part that covers a cell, if it hangs, and the parts above it. */
    void supportAt(const glm::ivec3& cell);

    std::size_t getCount() const { return static_cast<std::size_t>(std::count(_hangs.begin(), _hangs.end(), true)); }

private:
    void support(std::uint32_t part);

    JointGraph _graph;
    std::vector<bool> _hangs;
    std::unordered_map<CellKey, std::uint32_t> _parts; // by the cells that they cover
};

} // namespace osgLego
