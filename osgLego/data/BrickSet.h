#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/data/BrickPoints.h>

#include <cstdint>
#include <functional>
#include <mutex>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The bricks of one source, as a producer delivers them: all that drawing, picking, bounds and export read.
 *
 * A set made on the CPU holds its points, which each context uploads. The points of a set made by the GPU stay in a
 * buffer of the context that made them (ContextBricks), and its model is made when it is first asked for.
 *
 * Immutable; every function may be called from any thread.
 */
class BrickSet : public osg::Referenced
{
public:
    using MakeModel = std::function<osg::ref_ptr<const BrickModel>()>;

    /** A set made on the CPU. Finds the points, and adds what is known of the bricks to the statistics.
     * @param revision the number of the source (LegoSource::revision). */
    BrickSet(std::uint64_t revision, const BrickModel& model, const LegoStatistics& statistics);
    /** A set made by the GPU. @param makeModel called at most once, by the thread that asks for the model first. */
    BrickSet(std::uint64_t revision, const BrickGrid& grid, MakeModel makeModel);

    std::uint64_t getRevision() const { return _revision; }
    const BrickGrid& getGrid() const { return _grid; }
    /** Whether the points are here, not on a GPU. */
    bool hasPoints() const { return _hasPoints; }
    /** The visible bricks, block by block; empty unless hasPoints(). */
    const BrickPoints& getPoints() const { return _points; }
    /** Every covered cell. May take as long as legolizeOnCpu() when it is first called. */
    osg::ref_ptr<const BrickModel> getModel() const;
    /** How the set was made; of a set made by the GPU, each context knows (ContextBricks::getStatistics). */
    const LegoStatistics& getStatistics() const { return _statistics; }

private:
    ~BrickSet() override = default;

    std::uint64_t _revision;
    BrickGrid _grid;
    bool _hasPoints;
    BrickPoints _points;
    LegoStatistics _statistics;
    MakeModel _makeModel;
    mutable std::once_flag _modelFlag;
    mutable osg::ref_ptr<const BrickModel> _model;
};

} // namespace osgLego
