#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <optional>

namespace osgLego
{

/** Cut triangles that reach far beyond the grid, and drop the parts that don't reach into it, so that they cost neither
 * passes nor memory.
 *
 * They are cut in the pattern of the subdivision pass, so that it makes the same fine triangles from the parts as from
 * the whole. Uses no GL; may be called from any thread.
 * @return the parts, which keep the number of their source triangle; none if no triangle reaches far beyond the grid.
 */
std::optional<GridBatch> cutToGrid(const GridBatch& batch, const GridTriangles& triangles, double edgeLimit);

} // namespace osgLego
