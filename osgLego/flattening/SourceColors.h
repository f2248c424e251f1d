#pragma once

#include <osgLego/flattening/GridTriangles.h>
#include <osgLego/palette/ColorHistogram.h>

namespace osgLego
{

/** The colours of the visible surface of a source inside its grid, weighted by area. They are known before the cells
 * are, so that cells made on the GPU and on the CPU get one palette.
 *
 * The colours are those at points spread evenly over the surface, about one in 65,000 of its area. A point is ignored
 * if it is farther than a thirty-second of the grid's longest side from any place that is open to the outside, as the
 * surface around such places shows. The same source gives the same histogram. May be called from any thread. */
ColorHistogram histogramOf(const GridTriangles& triangles);

} // namespace osgLego
