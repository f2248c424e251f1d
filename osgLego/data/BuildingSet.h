#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/data/BuildingPoints.h>
#include <osgLego/data/RankBlocks.h>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** A model that can be drawn and picked with only its first parts in place. Without parts, each brick counts as one,
 * and they are put in place from bottom to top.
 *
 * Immutable; every function may be called from any thread.
 */
class BuildingSet : public osg::Referenced
{
public:
    /** @param revision that of the brick set (BrickSet::getRevision()) with this model.
     * @param plan for the model's parts; null without parts. */
    BuildingSet(std::uint64_t revision, const BrickModel& model, const BuildingPlan* plan);

    std::uint64_t getRevision() const { return _revision; }
    const BrickModel& getModel() const { return *_model; }
    const BuildingPlan* getPlan() const { return _plan; }
    const BuildingPoints& getPoints() const { return _points; }

    /** The ranks of all cells (see osgLego::createRankBlocks). */
    std::vector<std::uint32_t> createRankBlocks() const { return osgLego::createRankBlocks(*_model, _ranks); }

    /** The number of parts. */
    std::size_t getNumParts() const { return _ranks.size(); }
    /** The number of parts in place. @param progress 0 to 1. */
    std::size_t getNumPlaced(double progress) const;
    /** The model of the parts in place; the last one is kept. */
    osg::ref_ptr<const BrickModel> getPlacedModel(std::size_t numPlaced) const;

private:
    ~BuildingSet() override = default;

    std::uint64_t _revision;
    osg::ref_ptr<const BrickModel> _model;
    osg::ref_ptr<const BuildingPlan> _plan;
    std::vector<std::uint32_t> _ranks; // of the parts
    BuildingPoints _points;
    mutable std::mutex _mutex; // guards the model of the parts in place
    mutable std::size_t _numPlaced = 0;
    mutable osg::ref_ptr<const BrickModel> _placedModel;
};

} // namespace osgLego
