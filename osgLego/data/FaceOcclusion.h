#pragma once

#include <osgLego/data/BrickPoints.h>
#include <osgLego/data/OcclusionVolume.h>
#include <osgLego/data/VoxelGrid.h>

#include <span>

namespace osgLego
{

/** The light that is hidden from the middles of all open faces of bricks, in the voxels in front of them (class
 * DistantOcclusion). `mean` includes near occlusion; `bend` and `distant` are those of the hits that
 * createOcclusionTable() does not know. May be called from any thread.
 * @param grid whose voxels are cells. @param reach the length of rays, in pitches. */
OcclusionVolume findFaceOcclusion(const VoxelGrid& grid, std::span<const BrickPoint> points, double reach);

} // namespace osgLego
