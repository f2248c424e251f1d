#include <osgLego/model/HiddenCells.h>

#include <osgLego/data/CellKeys.h>
#include <osgLego/model/CellExposure.h>
#include <osgLego/model/LaidBox.h>

#include <map>
#include <unordered_set>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

/** The exposure up to which a cell counts as hidden: it can be seen through holes. */
constexpr double MOST_EXPOSED = 0.1;

} // namespace

std::vector<LayoutCell> findHiddenCells(const LayoutProblem& problem, const LaidParts& parts,
                                        const std::vector<std::uint32_t>& near, int reach)
{
    if (problem.cells.empty()) return {};
    std::unordered_set<CellKey> seen;
    for (const LayoutCell& cell : problem.cells)
        seen.insert(toCellKey({cell.place[0], cell.place[1], cell.place[2]}));
    const CellExposure exposure(problem);
    const glm::ivec3 ground(0, 0, problem.cells.front().place[2]);
    std::map<CellKey, LayoutCell> found;
    for (const std::uint32_t part : near)
    {
        BuildingBox box = toBox(parts[part]);
        box.lower = glm::max(box.lower - reach, ground);
        box.upper = glm::min(box.upper + reach, problem.size);
        visitCells(box,
                   [&](const glm::ivec3& cell)
                   {
                       if (!seen.insert(toCellKey(cell)).second || exposure.get(cell) > MOST_EXPOSED) return;
                       found[toCellKey(cell)] = {{static_cast<std::uint16_t>(cell.x),
                                                  static_cast<std::uint16_t>(cell.y),
                                                  static_cast<std::uint16_t>(cell.z)}};
                   });
    }
    std::vector<LayoutCell> cells;
    cells.reserve(found.size());
    for (const auto& [key, cell] : found)
        cells.push_back(cell);
    return cells;
}

} // namespace osgLego
