#pragma once

#include <osgLego/BrickModel.h>

#include <memory>

namespace osgLego
{

/** The unlikeness of a model to a surface. */
struct SurfaceDifference
{
    /** The distance between the outer sides of bricks and the surface, in model units: the root of the mean square over
     * their area. Their corners, edges and studs do not count, only the middle of each side of each cell. */
    double distance = 0.0;
    double color = 0.0; //!< the mean difference (CIEDE2000) to the nearest place of the surface, over the same area
    /** The share of the surface, as far as it can be seen from outside, that is more than one and a quarter of the
     * longest edge of a cell away from all outer sides: in gaps that bricks close, or where there are none. */
    double lost = 0.0;
};

/** The surface of a mesh as the centres and colours of small cells, to which models of larger cells are compared.
 *
 * Immutable; may be called from any thread. */
class SurfaceReference
{
public:
    /** @param cells the cells that the mesh covers, much smaller than those of models, in the colours of the mesh. Not
     * empty. */
    explicit SurfaceReference(const BrickModel& cells);
    ~SurfaceReference();

    /** @param model with at least one brick, in the same coordinates. Sides inside closed cavities do not count. */
    SurfaceDifference compare(const BrickModel& model) const;

private:
    struct Places; // of Boost.Geometry, whose headers take long to compile

    std::unique_ptr<const Places> _places;
};

} // namespace osgLego
