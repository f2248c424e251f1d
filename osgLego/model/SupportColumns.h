#pragma once

#include <osgLego/model/SupportedLayout.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

class CellExposure;

/** The parts of a column, from bottom to top: bricks and, where a grid of plates needs them, plates on top. */
LaidParts buildColumn(const SupportColumn& column, bool isOfPlates);

/** A layout with more columns. */
SupportedLayout addColumns(const SupportedLayout& layout, const std::vector<SupportColumn>& columns);

/** A layout without some of its columns, on which no others stand. */
SupportedLayout removeColumns(const SupportedLayout& layout, std::span<const SupportColumn> columns);

/** How much of a column would be seen: the sum of the exposures of its cells. */
double sumExposure(const SupportColumn& column, const CellExposure& exposure);

/** Finds places for columns below the parts of a layout, through empty cells down to a part or to the ground.
 *
 * The layout must exist as long as this object. One thread. */
class SupportColumns
{
public:
    SupportColumns(const LayoutProblem& problem, const LaidParts& parts);

    /** Columns below some parts: first where the column is seen least, then in the middle and at the outermost places
     * in eight directions.
     * @param below indices of parts. @return none if no place below them is free. */
    std::vector<SupportColumn> find(const std::vector<std::uint32_t>& below) const;

    /** Mark the cells of a column as covered. */
    void add(const SupportColumn& column);

private:
    bool isFree(const glm::ivec3& cell) const;
    SupportColumn makeColumn(const glm::ivec3& top, int width, std::uint16_t color) const;
    std::vector<int> getVisibilities(const std::vector<SupportColumn>& columns) const;
    SupportColumn widen(const SupportColumn& column) const;

    const LayoutProblem& _problem;
    const LaidParts& _parts;
    std::unordered_set<std::uint64_t> _covered;
    int _ground; //!< the height of the lowest cells
};

} // namespace osgLego
