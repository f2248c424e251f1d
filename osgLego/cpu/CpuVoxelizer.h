#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/flattening/GridTriangles.h>

#include <osg/ref_ptr>

namespace osgLego
{

/** The bricks of triangles that are in their grid already, as legolizeOnCpu() finds them; without triangles, a model
 * without bricks. May be called from any thread; works in all threads that oneTBB gives the caller. */
osg::ref_ptr<const BrickModel> voxelizeOnCpu(const GridTriangles& triangles);

} // namespace osgLego
