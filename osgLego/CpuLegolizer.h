#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/LegoSettings.h>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** The bricks of a mesh, found on the CPU, without GL: the same cells as VoxelizationMethod::EXACT finds on the GPU.
 *
 * A cell is covered when a triangle overlaps it, decided in double precision. Its colour: every
 * covering triangle speaks for the point of it nearest the cell's centre (colour and texture coordinate interpolated
 * there, the texture filtered to the size of a cell), weighted by its area inside the cell. The method, target, FBO
 * size and edge limit of the settings play no part.
 *
 * Usage:
 *
 *     osg::ref_ptr<const osgLego::BrickModel> model = osgLego::legolizeOnCpu(*node, settings);
 *     if (!model) ... // no triangles, or settings.check() complains
 *
 * May be called from any thread as long as no other one changes the node. Works in all threads that oneTBB gives the
 * caller (oneapi::tbb::task_arena, oneapi::tbb::global_control); the result does not depend on how many. Memory grows
 * with the covered cells, and with the grid by one bit for each cell of the rows that are near to any: at most 128 MiB
 * at 1024 x 1024 x 1024.
 *
 * @return null, with a warning that says why, when the node shows no triangles or the settings are not allowed. */
OSGLEGO_EXPORT osg::ref_ptr<const BrickModel> legolizeOnCpu(const osg::Node& node, const LegoSettings& settings);

} // namespace osgLego
