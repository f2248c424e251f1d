#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/BrickPoints.h>
#include <osgLego/data/OcclusionVolume.h>
#include <osgLego/data/VoxelGrid.h>

#include <span>

namespace osgLego
{

/** The light that bricks which createOcclusionTable() does not know hide from open faces, in voxels of several cells
 * (class DistantOcclusion).
 *
 * Rays start in the middles of the faces in a voxel. Up to a distance of two and a half voxels they meet the bricks
 * themselves, so that nothing is missing between near and distant occlusion; beyond it, voxels. `mean` and `bend` are
 * the hidden fractions of the light that near occlusion leaves, of surfaces that face both ends of the axes. May be
 * called from any thread.
 * @param points the visible bricks, which have covered `voxels`. @param reach the length of rays, in pitches; three
 * voxels shorter than that of `voxels`. */
OcclusionVolume findCoarseFaceOcclusion(const BrickGrid& grid, const VoxelGrid& voxels,
                                        std::span<const BrickPoint> points, double reach);

} // namespace osgLego
