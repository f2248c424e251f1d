#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/LegoStatistics.h>

#include <functional>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Make the bricks of a mesh on the CPU, without GL.
 *
 * A cell is covered when a triangle overlaps it, which is decided in double precision. VoxelizationMethod::EXACT finds
 * the same cells on the GPU, except cells that a triangle merely grazes: the GPU works in single precision. The colour
 * of a cell is the average over its triangles, weighted by their area inside the cell. Each triangle contributes the
 * colour of its point nearest the cell's centre: vertex colours and texture coordinates are interpolated there, and the
 * texture is filtered to the size of a cell. With a palette, a cell gets the palette's colour nearest to one of the
 * colours of its triangles, the one nearest to the average. The method, target, FBO size, edge limit and device of the
 * settings are ignored.
 *
 * Usage:
 *
 *     osg::ref_ptr<const osgLego::BrickModel> model = osgLego::legolizeOnCpu(*node, settings);
 *     if (!model) ... // no triangles, or settings.check() reports an error
 *
 * May be called from any thread as long as no other thread changes the node. Uses all threads that oneTBB gives the
 * caller (oneapi::tbb::task_arena, oneapi::tbb::global_control); the result does not depend on their number. Memory
 * grows with the number of covered cells, plus one bit for each cell in the rows of the grid near them: at most 128 MiB
 * at 1024 x 1024 x 1024.
 *
 * @param statistics receives the statistics of the bricks; may be null.
 * @param proceed called in this thread, with 0 at the beginning, then with the fraction of a layout of parts that is
 * done, up to 1, and with 1 while pieces are joined and the model is supported; the function ends soon after it returns
 * false. May be empty.
 * @return null if `proceed` ended it, and with a warning that gives the reason if the node has no visible triangles,
 * settings.check() reports an error, the palette can't be read, or the cells would be too many; a model without bricks
 * if the grid misses the triangles.
 * @throws std::bad_alloc if there is not enough memory. */
OSGLEGO_EXPORT osg::ref_ptr<const BrickModel> legolizeOnCpu(const osg::Node& node, const LegoSettings& settings,
                                                            LegoStatistics* statistics = nullptr,
                                                            const std::function<bool(double)>& proceed = {});

} // namespace osgLego
