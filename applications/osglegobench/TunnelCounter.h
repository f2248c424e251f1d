#pragma once

#include "CellSet.h"

#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>

namespace osgLego
{

/** How many segments between the centres of two empty face-neighbours a triangle crosses. What lies around the grid is
 * empty too. A segment holds its lower end and not its upper, so that no surface is counted twice along an axis; a
 * triangle that lies along a segment does not cross it. */
std::size_t countTunnels(const GridTriangles& triangles, const CellSet& covered);

} // namespace osgLego
