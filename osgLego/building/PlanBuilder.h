#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/PlanningOptions.h>
#include <osgLego/building/StepBuilder.h>
#include <osgLego/stability/JointGraph.h>

#include <limits>
#include <map>
#include <tuple>
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

    static constexpr std::size_t ANY = std::numeric_limits<std::size_t>::max();

    /** Called once.
     * @param mostFalling steps of the model after which parts may fall, not counting those of submodels. The plan is
     * given up as soon as there are more, before another way is tried, which rarely has fewer.
     * @return null if it was cancelled or given up. */
    osg::ref_ptr<const BuildingPlan> build(std::size_t mostFalling = ANY);

private:
    using PartList = std::vector<std::uint32_t>;

    /** How parts are built. */
    struct Setting
    {
        std::size_t depth = 0; // 1 for submodels of the model, 2 for those within such submodels, and so on
        bool isUpsideDown = false;
        bool isLimited = false; // whether submodels within it keep to the limits of size and depth
        BuildingBase base = BuildingBase::TABLE;
    };

    /** Steps, and the submodels in them, which are not yet in _submodels. */
    struct Attempt
    {
        std::vector<BuildingStep> steps;
        std::vector<Submodel> submodels;
        std::size_t numFalls = 0; // steps after which parts fall, also of all submodels, however small
        std::size_t largest = 0;  // parts of the largest submodel that the steps attach
    };

    std::vector<PartList> findPieces() const;
    std::vector<BuildingStep> planSequence(const PartList& parts, const Setting& setting);
    Attempt attempt(const PartList& parts, const Setting& setting);
    void planSteps(const PartList& parts, const Setting& setting, Attempt& attempt);
    std::vector<AssemblyStep> assemble(const PartList& parts, const Setting& setting);
    double getCellHeight() const;
    std::uint32_t planSubmodel(const PartList& parts, Setting setting);
    bool isBetterUpsideDown(const PartList& parts) const;
    std::vector<BuildingBox> select(const PartList& parts, bool isUpsideDown) const;
    void addUnheld(const PartList& parts, BuildingStep& step);
    bool proceed(std::size_t numPlaced, bool stands);

    const BrickModel& _model;
    const PlanningOptions& _options;
    std::vector<BuildingBox> _boxes;
    std::vector<BuildingBox> _turnedBoxes; // upside down
    /** The steps of parts that are built upside down or not, with submodels of some parts at most: attempts to build
     * parts in other ways have many submodels in common. */
    std::map<std::tuple<PartList, bool, std::size_t>, std::vector<AssemblyStep>> _assemblies;
    std::vector<Submodel> _submodels;
    PartList _unheld;
    bool _isTryingAgain = false;     // another way; submodels within are not tried again
    std::size_t _numFallsLeft = ANY; // the steps after which parts may fall until an attempt is given up
    std::size_t _mostFalling = ANY;  // steps of the model after which parts may fall
    std::size_t _numFalling = 0;     // those of the first attempt
    bool _isGivenUp = false;
    bool _isCancelled = false;
};

} // namespace osgLego
