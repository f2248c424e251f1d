#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/PlanningOptions.h>
#include <osgLego/stability/JointGraph.h>

#include <vector>

namespace osgLego
{

/** Makes the steps of a model and of its submodels, which are built by the same rules.
 *
 * Usage:
 *
 *     PlanBuilder builder(model, options);
 *     osg::ref_ptr<const BuildingPlan> plan = builder.build(); // null if it was cancelled
 *
 * One thread.
 */
class PlanBuilder
{
public:
    /** The arguments must outlive this object. */
    PlanBuilder(const BrickModel& model, const PlanningOptions& options);

    osg::ref_ptr<const BuildingPlan> build();

private:
    using PartList = std::vector<std::uint32_t>;

    /** How parts are built. */
    struct Setting
    {
        bool isSubmodel = false;
        bool isUpsideDown = false;
        BuildingBase base = BuildingBase::TABLE;
    };

    std::vector<PartList> findPieces() const;
    std::vector<BuildingStep> planSteps(const PartList& parts, const Setting& setting);
    double getCellHeight() const;
    std::uint32_t planSubmodel(const PartList& parts);
    std::size_t countFalls(const std::vector<BuildingStep>& steps, std::ptrdiff_t firstSubmodel) const;
    bool isBetterUpsideDown(const PartList& parts) const;
    std::vector<BuildingBox> select(const PartList& parts, bool isUpsideDown) const;
    void addUnheld(const PartList& parts, BuildingStep& step);
    bool proceed(std::size_t numPlaced);

    const BrickModel& _model;
    const PlanningOptions& _options;
    std::vector<BuildingBox> _boxes;
    std::vector<BuildingBox> _turnedBoxes; // upside down
    std::vector<Submodel> _submodels;
    PartList _unheld;
    bool _isTryingAgain = false; // the other way up; nested submodels are not tried again
    bool _isCancelled = false;
};

} // namespace osgLego
