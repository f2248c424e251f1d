#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/BrickPoints.h>

#include <span>

#include <glm/vec3.hpp>
#include <osg/Image>
#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The light that distant bricks hide from the surroundings of bricks, in a coarse grid of voxels.
 *
 * A voxel is a block of cells of about the same width, depth and height. From the centre of each empty voxel near a
 * brick, rays in all directions end at the first voxel with bricks. A hit at a distance t counts with the weight
 * fade(t, reach) - fade(t, near), where fade(t, r) = clamp((r - t) / (r * falloff), 0, 1): the part of the occlusion up
 * to `reach` that the search for near occluders leaves out. For a surface with normal n, the hidden fraction of the
 * cosine-weighted sky is approximately
 *
 *     a + dot(b, n), where a = mean(weight) and b = 2 * mean(weight * direction)
 *
 * which is exact if all directions on one side of a plane are hidden (the first two bands of spherical harmonics;
 * Ramamoorthi and Hanrahan 2001). Voxels with bricks have the mean of their empty neighbours.
 *
 * Immutable; every function may be called from any thread.
 */
class DistantOcclusion : public osg::Referenced
{
public:
    /** The greatest number of voxels along an axis. */
    static constexpr int MAXIMUM_SIZE = 64;
    /** The greatest distance of occluders, as a part of the longest side of the grid. */
    static constexpr double REACH = 0.25;

    /** Voxels around the grid, so that samples at its border are interpolated, too. */
    static constexpr int BORDER = 1;

    /** @param points the visible bricks. */
    static osg::ref_ptr<const DistantOcclusion> create(const BrickGrid& grid, std::span<const BrickPoint> points);

    /** The voxels as a picture of bytes: b, from -1 to 1 in axes of the model, as 0 to 254; and a, from 0 to 1. */
    const osg::Image& getImage() const { return *_image; }
    /** The number of cells in a voxel, along each axis. */
    const glm::ivec3& getCellsPerVoxel() const { return _cellsPerVoxel; }

private:
    DistantOcclusion(const glm::ivec3& cellsPerVoxel, osg::Image& image) : _cellsPerVoxel(cellsPerVoxel), _image(&image)
    {
    }
    ~DistantOcclusion() override = default;

    glm::ivec3 _cellsPerVoxel;
    osg::ref_ptr<osg::Image> _image;
};

} // namespace osgLego
