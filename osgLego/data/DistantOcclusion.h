#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/BrickPoints.h>
#include <osgLego/data/OcclusionVolume.h>
#include <osgLego/data/VoxelGrid.h>

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

/** The light that bricks hide from the surroundings of bricks, in a grid of voxels: distant occlusion, or all of it.
 *
 * A hit of a ray at a distance t hides the fraction fade(t, reach) (fadeOcclusion()). For NearOcclusion::PICTURE, a
 * voxel is a block of cells of about the same width, depth and height. From the centre of each empty voxel near a
 * brick, rays in all directions end at the first voxel with bricks. They count with the weight fade(t, reach) -
 * fade(t, radius), with the radius of near occlusion, in voxels if they are wider than bricks. For each of the six
 * directions of the axes, the voxel has the cosine-weighted mean of the weights of the rays on that side: the fraction
 * of the sky that is hidden from a surface facing there. Surfaces that face other directions interpolate these with the
 * squares of their normal's components (the ambient cube of McTaggart 2004). Voxels with bricks have the mean of their
 * empty neighbours.
 *
 * For NearOcclusion::GRID, voxels are cells, unless there are too many: then they are blocks of cells, and have the
 * light that bricks which near occlusion does not know hide from their faces (findCoarseFaceOcclusion()). Otherwise,
 * from the middle of each open face, rays find all the light that is hidden from it, near and far. Between the middles
 * of faces it is interpolated, so that it has no seams; the table of near occlusion then adds the difference to the
 * exact occlusion (createOcclusionTable()). So that this holds at edges, too, rays also start in empty cells beside
 * open faces, in their planes. Voxels without such a face have the mean of their neighbours. Distant occlusion alone,
 * which excludes what near occlusion knows, is there as its mean over the faces of a voxel and as its direction.
 *
 * Immutable; every function may be called from any thread.
 */
class DistantOcclusion : public osg::Referenced
{
public:
    /** The greatest number of voxels along an axis for NearOcclusion::PICTURE, without the border. */
    static constexpr int MAXIMUM_SIZE = 64;
    /** Likewise for NearOcclusion::GRID. Voxels are cells if there are no more of them than in a cube of this side. */
    static constexpr int MAXIMUM_CELLS = 128;
    static constexpr int BORDER = VoxelGrid::BORDER;
    /** The greatest distance of occluders, in pitches: a quarter of the longest side of the grid. */
    static double getReach(const BrickGrid& grid);

    /** @param points the visible bricks. */
    static osg::ref_ptr<const DistantOcclusion> create(const BrickGrid& grid, std::span<const BrickPoint> points,
                                                       NearOcclusion near);

    /** The hidden fractions, 0 to 1, of surfaces across the axes, as means of both directions: red for x, green for y,
     * blue for z, in bytes, with mipmaps. Alpha is the mean fraction hidden by distant bricks, if includesNear(). */
    const osg::Image& getMean() const { return *_images[0]; }
    /** Half the difference between surfaces that face the upper and the lower ends of the axes, plus 128 / 255,
     * likewise: the direction from which distant bricks hide light. */
    const osg::Image& getBend() const { return *_images[1]; }
    /** The number of cells in a voxel, along each axis. */
    const glm::ivec3& getCellsPerVoxel() const { return _cellsPerVoxel; }
    /** Whether the hidden fractions of faces include near occlusion. */
    bool includesNear() const { return _includesNear; }

private:
    DistantOcclusion(const VoxelGrid& grid, const OcclusionVolume& volume, bool includesNear);
    ~DistantOcclusion() override = default;

    glm::ivec3 _cellsPerVoxel;
    std::array<osg::ref_ptr<osg::Image>, 2> _images;
    bool _includesNear;
};

} // namespace osgLego
