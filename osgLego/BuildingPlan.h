#pragma once

#include <osgLego/Export.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The parts that are put in place together, and the picture of them. */
struct BuildingStep
{
    static constexpr int NUM_TURNS = 4;
    static constexpr double AZIMUTH = 33.0;   //!< degrees from the front to the right, by default
    static constexpr double ELEVATION = 30.0; //!< degrees above the horizon, by default

    /** Indices into BrickModel::getParts(), in the order of placing, without those of `submodels`. */
    std::vector<std::uint32_t> parts;
    /** Indices of submodels, each built before, that are attached after `parts`. */
    std::vector<std::uint32_t> submodels;
    /** The quarter turns, 0 to 3, of the view about the up axis, counter-clockwise from above. */
    int turns = 0;
    /** Whether the submodel is built, and seen, upside down: all its steps are, or none. Steps of the model never are.
     */
    bool isFromBelow = false;
    /** Whether the partial model stands after this step; true if nothing is known. */
    bool stands = true;
    /** Whether `stands` was computed, and not assumed. */
    bool isChecked = false;

    bool operator==(const BuildingStep&) const = default;
};

/** Parts that are built apart from the rest, and then attached to it as a whole. */
struct Submodel
{
    std::vector<BuildingStep> steps; //!< at least one

    bool operator==(const Submodel&) const = default;
};

/** An order in which a model can be built by hand, in steps.
 *
 * Every part of the model is in exactly one step, of the main sequence or of a submodel, and each submodel is attached
 * in exactly one step.
 *
 * Usage:
 *
 *     osg::ref_ptr<const osgLego::BuildingPlan> plan = osgLego::planBuilding(*model, options);
 *     for (const osgLego::BuildingStep& step : plan->getSteps()) ...
 *
 * Uses no GL. Immutable once created; every function may be called from any thread.
 */
class OSGLEGO_EXPORT BuildingPlan : public osg::Referenced
{
public:
    static constexpr std::size_t MOST_SUBMODEL_PARTS = 150; //!< of a submodel that is easy to handle
    /** Submodels within each other that are easy to follow: 1 for a submodel of the model, 2 for one within such a
     * submodel, and so on. */
    static constexpr std::size_t DEEPEST_SUBMODEL = 3;
    static constexpr std::size_t MOST_FALLING_STEPS = 5; //!< after which a builder holds the model
    static constexpr std::size_t MOST_PARTS_HELD = 4;    //!< of a submodel that a builder holds while building it

    /** Create a plan.
     * @param numParts the number of parts in the model.
     * @param unheld parts, in ascending order, that nothing holds when they are placed.
     * @param submodels in any order: one may come before those that it contains.
     * @return null if the steps do not contain each part, and each submodel, exactly once, if a submodel contains
     * itself, if a step, or a submodel, has nothing to place, if `turns` is not 0 to 3, if a main step or only some
     * steps of a submodel are from below, or if `unheld` is not in ascending order or has unknown parts. */
    static osg::ref_ptr<const BuildingPlan> create(std::size_t numParts, std::vector<BuildingStep> steps,
                                                   std::vector<Submodel> submodels = {},
                                                   std::vector<std::uint32_t> unheld = {});

    const std::vector<BuildingStep>& getSteps() const { return _steps; }
    const std::vector<Submodel>& getSubmodels() const { return _submodels; }
    /** Parts that nothing holds when they are placed, in ascending order: a model with such parts can't be built. */
    const std::vector<std::uint32_t>& getUnheldParts() const { return _unheld; }

    /** The number of steps, with those of submodels, that are not `isChecked`: it is unknown whether the partial model
     * stands after them. */
    std::size_t getNumUnchecked() const;
    /** The number of steps, with those of submodels of more than MOST_PARTS_HELD parts, after which the partial model
     * does not stand. */
    std::size_t getNumFalling() const;

    /** The parts of the largest submodel; 0 without submodels. Parts that nothing holds are not counted, here and in
     * getDeepestSubmodel(). */
    std::size_t getLargestSubmodel() const { return _largestSubmodel; }
    /** How deep submodels are nested; 0 without submodels. */
    std::size_t getDeepestSubmodel() const { return _deepestSubmodel; }
    /** Whether the model is easy to build: all submodels are within MOST_SUBMODEL_PARTS and DEEPEST_SUBMODEL, and
     * getNumFalling() within MOST_FALLING_STEPS. */
    bool keepsLimits() const;
    /** Whether the plan is less far beyond these limits than another one: what is beyond each counts in multiples of
     * that limit, so that a step is as bad as 30 parts, and a level as bad as 50. */
    bool exceedsLimitsLessThan(const BuildingPlan& other) const;

    /** The parts of a step and of its submodels, in the order in which they are put in place. */
    std::vector<std::uint32_t> getPlacedParts(const BuildingStep& step) const;
    /** All parts in the order of building: those of each main step in turn, a submodel's where it is attached. */
    const std::vector<std::uint32_t>& getOrder() const { return _order; }
    /** For each part, its place in getOrder(). */
    const std::vector<std::uint32_t>& getRanks() const { return _ranks; }
    /** The number of parts in place after a main step. @param step an index into getSteps(). */
    std::size_t getNumPlaced(std::size_t step) const { return _numPlaced[step]; }

private:
    BuildingPlan() = default;
    ~BuildingPlan() override = default;

    void measureSubmodels(const std::vector<BuildingStep>& steps, std::size_t depth);
    std::size_t getExcess() const;

    std::vector<BuildingStep> _steps;
    std::vector<Submodel> _submodels;
    std::vector<std::uint32_t> _unheld;
    std::vector<std::uint32_t> _order;
    std::vector<std::uint32_t> _ranks;
    std::vector<std::size_t> _numPlaced;
    std::size_t _largestSubmodel = 0;
    std::size_t _deepestSubmodel = 0;
};

} // namespace osgLego
