#pragma once

#include <osgLego/flattening/GridTriangles.h>
#include <osgLego/palette/ColorHistogram.h>

namespace osgLego
{

/** The colours of the visible surface of a source inside its grid, weighted by area. They are known before the cells
 * are, so that cells made on the GPU and on the CPU get one palette.
 *
 * The colours are those at points spread evenly over the surface, about one in 65,000 of its area. An enclosed point is
 * ignored: one that is farther than a thirty-second of the grid's longest side from every place that is connected to
 * the outside. The same source gives the same histogram. May be called from any thread. */
ColorHistogram histogramOf(const GridTriangles& triangles);

} // namespace osgLego
