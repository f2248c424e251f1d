#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoSettings.h>

#include <cstddef>
#include <string>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** Covered cells and interior cells. */
struct FilledCells
{
    std::vector<Brick> bricks;    //!< sorted by the number of their cell; `openSides` are not set
    std::vector<bool> isInterior; //!< of each brick; an interior cell has the colour of a covered cell in its row
    std::size_t numInterior = 0;
    bool isHollow = false; //!< whether interior cells were left out inside a shell
};

/** Add interior cells to a model: empty cells from which every path through empty cells, side by side, ends at a
 * covered cell inside the grid. A mesh that has a hole wider than a cell, or that the grid cuts open, has none.
 *
 * @param fill SURFACE adds none; SHELL adds those at most `shell` steps, side by side, from an empty cell outside.
 * @return false, with one sentence in `error`, if there would be more than GridLimits::MOST_BRICKS.
 * @throws std::bad_alloc if there is not enough memory. */
bool fillCells(const BrickModel& model, Fill fill, unsigned int shell, FilledCells& cells, std::string& error);

} // namespace osgLego
