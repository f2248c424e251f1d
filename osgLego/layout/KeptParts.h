#pragma once

#include <osgLego/layout/PartMap.h>

#include <vector>

namespace osgLego
{

/** Lay the parts of an earlier layout whose cells still exist, may have its colour, and are not covered. */
void keepParts(PartMap& map, const PartSizes& sizes, const LaidParts& previous);

/** Of each cell, whether it is uncovered or at most `distance` steps from an uncovered cell. */
std::vector<bool> findChangedCells(const PartMap& map, int distance);

} // namespace osgLego
