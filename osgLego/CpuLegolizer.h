#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/LegoSettings.h>

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
 * texture is filtered to the size of a cell. The method, target, FBO size and edge limit of the settings are ignored.
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
 * @return null, with a warning that gives the reason, if the node has no visible triangles, settings.check() reports an
 * error, or the cells of the given size would be too many; a model without bricks if the grid misses the triangles. */
OSGLEGO_EXPORT osg::ref_ptr<const BrickModel> legolizeOnCpu(const osg::Node& node, const LegoSettings& settings);

} // namespace osgLego
