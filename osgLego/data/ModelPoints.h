#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/BrickNeighbors.h>
#include <osgLego/data/BrickPoints.h>
#include <osgLego/data/DistantOcclusion.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <vector>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The points of a model and their distant occlusion, which brick sets of the same model share.
 *
 * Immutable; every function may be called from any thread.
 */
class ModelPoints : public osg::Referenced
{
public:
    /** The points of a model: those that are in use, or new ones. */
    static osg::ref_ptr<const ModelPoints> get(const BrickModel& model);

    explicit ModelPoints(const BrickModel& model);

    const BrickPoints& getPoints() const { return _points; }
    /** The neighbours of each point, computed by the first call. */
    const std::vector<BrickNeighbors>& getNeighbors() const;
    /** The distant occlusion, computed by the first call. */
    const DistantOcclusion& getDistantOcclusion(NearOcclusion near) const;
    /** Whether getDistantOcclusion() has been called. */
    bool hasDistantOcclusion(NearOcclusion near) const { return _occlusion[static_cast<std::size_t>(near)].isComputed; }

private:
    ~ModelPoints() override = default;

    struct Occlusion
    {
        std::once_flag flag;
        osg::ref_ptr<const DistantOcclusion> distant;
        std::atomic<bool> isComputed{false};
    };

    BrickGrid _grid;
    BrickPoints _points;
    mutable std::once_flag _neighborsFlag;
    mutable std::vector<BrickNeighbors> _neighbors;
    mutable std::array<Occlusion, 2> _occlusion; // by NearOcclusion
};

} // namespace osgLego
