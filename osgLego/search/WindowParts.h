#pragma once

#include <osgLego/layout/PartSizes.h>
#include <osgLego/search/CellSet.h>

#include <vector>

namespace osgLego
{

using WindowCells = CellSet<2>;

/** A part that could be laid in a window. */
struct WindowPart
{
    WindowCells cells;
    int cost = 0;
    PartShape shape;
};

/** The parts that could be laid in a window, ordered by their first cells. */
struct WindowParts
{
    std::vector<WindowPart> parts;
    std::vector<int> starts; //!< for each cell, the first part that begins there; then the number of parts

    int getNumCells() const { return static_cast<int>(starts.size()) - 1; }
};

} // namespace osgLego
