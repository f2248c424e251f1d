#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/BrickPoints.h>

#include <array>
#include <span>

#include <glm/vec3.hpp>
#include <osg/Image>
#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The kinds of near occlusion that distant occlusion completes. */
enum class NearOcclusion
{
    PICTURE, //!< of everything up to the radius of AmbientOcclusionSettings
    GRID     //!< of the cells that BrickNeighbors and createOcclusionTable() know
};

/** The light that distant bricks hide from the surroundings of bricks, in a coarse grid of voxels.
 *
 * A voxel is a block of cells of about the same width, depth and height. From the centre of each empty voxel near a
 * brick, rays in all directions end at the first voxel with bricks. A hit at a distance t counts with the weight
 * fade(t, reach) - fade(t, radius), where fade(t, r) = clamp((r - t) / (r * falloff), 0, 1), with the default radius
 * and falloff of AmbientOcclusionSettings, in voxels if they are wider than bricks: the part of the occlusion up to
 * `reach` that near occlusion leaves out. If that is NearOcclusion::GRID, and voxels are cells, hits outside the 3 x 3
 * x 3 cells in front of a face count with the weight fade(t, reach). For each of the six directions of the axes, the
 * voxel has the cosine-weighted mean of the weights of the rays on that side: the fraction of the sky that is hidden
 * from a surface facing there. Surfaces that face other directions interpolate these with the squares of their normal's
 * components (the ambient cube of McTaggart 2004). Voxels with bricks have the mean of their empty neighbours.
 *
 * Immutable; every function may be called from any thread.
 */
class DistantOcclusion : public osg::Referenced
{
public:
    /** The greatest number of voxels along an axis, without the border. */
    static constexpr int MAXIMUM_SIZE = 64;
    /** Voxels around the grid, so that samples at its border are interpolated, too. */
    static constexpr int BORDER = 1;
    /** The greatest distance of occluders, in pitches: a quarter of the longest side of the grid. */
    static double getReach(const BrickGrid& grid);

    /** @param points the visible bricks. */
    static osg::ref_ptr<const DistantOcclusion> create(const BrickGrid& grid, std::span<const BrickPoint> points,
                                                       NearOcclusion near);

    /** The hidden fractions, 0 to 1, of surfaces that face the upper (+x, +y, +z) or the lower (-x, -y, -z) ends of the
     * axes: red for x, green for y, blue for z, in bytes. */
    const osg::Image& getImage(bool upper) const { return *_images[upper ? 1 : 0]; }
    /** The number of cells in a voxel, along each axis. */
    const glm::ivec3& getCellsPerVoxel() const { return _cellsPerVoxel; }

private:
    explicit DistantOcclusion(const glm::ivec3& cellsPerVoxel) : _cellsPerVoxel(cellsPerVoxel) {}
    ~DistantOcclusion() override = default;

    glm::ivec3 _cellsPerVoxel;
    std::array<osg::ref_ptr<osg::Image>, 2> _images;
};

} // namespace osgLego
