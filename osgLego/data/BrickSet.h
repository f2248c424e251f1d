#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/data/ModelPoints.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The bricks of one source, as a producer delivers them. Drawing, picking, bounds and export read nothing else.
 *
 * A set made on the CPU holds its points, which each context uploads. The points of a set made on the GPU stay in a
 * buffer of the context that made them (ContextBricks), and its model is computed by the first getModel().
 *
 * Immutable; every function may be called from any thread.
 */
class BrickSet : public osg::Referenced
{
public:
    using MakeModel = std::function<osg::ref_ptr<const BrickModel>()>;
    using MeasureLayout = std::function<LayoutStatistics()>;

    /** Create a set made on the CPU. Computes the points, and adds their number to the statistics.
     * @param revision the number of the source (LegoSource::revision).
     * @param measureLayout computes the figures of parts; empty without parts.
     * @param shown the model with other colours, which are drawn; null: those of the model. */
    BrickSet(std::uint64_t revision, const BrickModel& model, const LegoStatistics& statistics,
             MeasureLayout measureLayout = {}, const BrickModel* shown = nullptr);
    /** Create a set made on the GPU. @param makeModel called at most once, by the first getModel(). */
    BrickSet(std::uint64_t revision, const BrickGrid& grid, MakeModel makeModel);

    std::uint64_t getRevision() const { return _revision; }
    const BrickGrid& getGrid() const { return _grid; }
    /** Whether the points are in this set, rather than in a buffer on the GPU. */
    bool hasPoints() const { return _points.valid(); }
    /** The visible bricks of a set that hasPoints(), block by block. */
    const BrickPoints& getPoints() const { return _points->getPoints(); }
    /** The neighbours of each point of a set that hasPoints(), computed by the first call. */
    const std::vector<BrickNeighbors>& getNeighbors() const { return _points->getNeighbors(); }
    /** The distant occlusion of a set that hasPoints(), computed by the first call. */
    const DistantOcclusion& getDistantOcclusion(NearOcclusion near) const { return _points->getDistantOcclusion(near); }
    /** Whether it has been computed. */
    bool hasDistantOcclusion(NearOcclusion near) const { return _points && _points->hasDistantOcclusion(near); }
    /** Every covered cell. The first call may take as long as legolizeOnCpu(). */
    osg::ref_ptr<const BrickModel> getModel() const;
    /** Statistics of a set made on the CPU; for one made on the GPU, see ContextBricks::getStatistics(). */
    const LegoStatistics& getStatistics() const { return _statistics; }
    /** The figures of parts made on the CPU, computed by the first call; unset without such parts. */
    std::optional<LayoutStatistics> getLayoutStatistics() const;

private:
    ~BrickSet() override = default;

    std::uint64_t _revision;
    BrickGrid _grid;
    osg::ref_ptr<const ModelPoints> _points; // null for a set made on the GPU
    LegoStatistics _statistics;
    MakeModel _makeModel;
    MeasureLayout _measureLayout;
    mutable std::once_flag _layoutFlag;
    mutable std::optional<LayoutStatistics> _layoutStatistics;
    mutable std::once_flag _modelFlag;
    mutable osg::ref_ptr<const BrickModel> _model;
};

} // namespace osgLego
