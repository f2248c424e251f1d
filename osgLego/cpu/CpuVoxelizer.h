#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/cpu/DominantColors.h>
#include <osgLego/cpu/PreviousCells.h>
#include <osgLego/flattening/GridTriangles.h>

#include <osg/ref_ptr>

namespace osgLego
{

/** Make the bricks of triangles that are already in their grid, as legolizeOnCpu() does; a model without bricks if
 * there are no triangles. May be called from any thread; uses all threads that oneTBB gives the caller.
 * @param color the colour of a cell that several triangles cover.
 * @param previous cells whose colours are preferred with CellColor::DOMINANT; null if there are none. */
osg::ref_ptr<const BrickModel> voxelizeOnCpu(const GridTriangles& triangles, CellColor color = CellColor::MEAN,
                                             const PreviousCells* previous = nullptr);

} // namespace osgLego
