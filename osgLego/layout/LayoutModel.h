#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Palette.h>
#include <osgLego/layout/CellFill.h>
#include <osgLego/layout/LayoutProblem.h>

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Prepare cells for a layout.
 * @param grid of bricks or plates (getCellPlates()).
 * @param colors the colours of the problem, at most 65535: a cell whose colour is not among them may have any. */
LayoutProblem createProblem(const FilledCells& cells, const BrickGrid& grid, const std::vector<PaletteColor>& colors);

/** Move parts of a layout from one grid to another of the same lattice, so that they keep their places in it. Parts
 * that lie partly below the other grid's corner are left out. */
LaidParts moveParts(const LaidParts& parts, const BrickGrid& from, const BrickGrid& to);

/** The colours of all covered cells, for models without a palette, as colours in which every size was made. */
std::vector<PaletteColor> collectColors(const FilledCells& cells);

/** The cell of a grid at a place of a layout of its cells. */
glm::ivec3 toGridCell(const glm::ivec3& place, const BrickGrid& grid);

/** The model of a layout in the grid of its cells.
 * @param covered as in BrickModel::createOfParts(). */
osg::ref_ptr<const BrickModel> createModel(const LaidParts& parts, const BrickGrid& grid,
                                           const std::vector<PaletteColor>& colors,
                                           const std::vector<Brick>& covered = {});

/** For each part of a layout, its index in the model of this layout. */
std::vector<std::uint32_t> findModelIndices(const LaidParts& parts, const BrickModel& model);

} // namespace osgLego
