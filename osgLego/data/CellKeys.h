#pragma once

#include <osgLego/data/BuildingBox.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace osgLego
{

/** A covered cell as a number that sorts by z, y and x. */
using CellKey = std::uint64_t;

inline constexpr CellKey CELL_RIGHT = 1;                 //!< from a key to that of the next cell along x
inline constexpr CellKey CELL_BEHIND = CellKey(1) << 16; //!< along y
inline constexpr CellKey CELL_ABOVE = CellKey(1) << 32;  //!< along z

inline CellKey toCellKey(const glm::ivec3& cell)
{
    return static_cast<CellKey>(cell.x) * CELL_RIGHT + static_cast<CellKey>(cell.y) * CELL_BEHIND +
           static_cast<CellKey>(cell.z) * CELL_ABOVE;
}

template <typename Visitor>
void visitCells(const BuildingBox& box, const Visitor& visit)
{
    for (int z = box.lower.z; z < box.upper.z; ++z)
        for (int y = box.lower.y; y < box.upper.y; ++y)
            for (int x = box.lower.x; x < box.upper.x; ++x)
                visit(glm::ivec3(x, y, z));
}

/** The cells of all boxes and the indices of their boxes, sorted. */
inline std::vector<std::pair<CellKey, std::uint32_t>> sortCells(const std::vector<BuildingBox>& boxes)
{
    std::vector<std::pair<CellKey, std::uint32_t>> cells;
    for (std::uint32_t part = 0; part < boxes.size(); ++part)
        visitCells(boxes[part], [&](const glm::ivec3& cell) { cells.emplace_back(toCellKey(cell), part); });
    std::sort(cells.begin(), cells.end());
    return cells;
}

} // namespace osgLego
