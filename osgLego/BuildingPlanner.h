#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/Export.h>
#include <osgLego/Stability.h>

#include <functional>

#include <osg/ref_ptr>

namespace osgLego
{

/** How a building plan is made. */
struct PlanningOptions
{
    BuildingBase base = BuildingBase::TABLE;
    /** Whether the stability of the partial model is checked after every step, and parts are placed accordingly. In
     * large models, some steps remain unchecked, which bounds the time: see BuildingPlan::getNumUnchecked(). */
    bool checksStability = true;
    /** Called regularly, from any thread; planBuilding() returns null soon after it returns true. May be empty. */
    std::function<bool()> isCancelled;
    /** Called with the fraction done, 0 to 1, in one thread. May be empty. */
    std::function<void(double)> progress;
};

/** Plan the steps in which a model is built.
 *
 * Steps go from bottom to top, region by region. No part is placed where nothing holds it, or below others: parts that
 * hang become submodels together with a part above them, which are built apart, some of them upside down, and attached
 * from above. Parts that no joints connect to the lowest layer can't be placed; they come last. A step has 5 to 10
 * parts where possible, and at most 12, a submodel counting as two; a step with submodels may have fewer.
 * docs/building.md has the rules.
 *
 * Needs no GL context; may be called from any thread.
 * @param model with parts that are in getPartTypes(); without parts, the plan has no steps.
 * @return the same plan for any number of threads; null if it was cancelled. */
OSGLEGO_EXPORT osg::ref_ptr<const BuildingPlan> planBuilding(const BrickModel& model,
                                                             const PlanningOptions& options = {});

} // namespace osgLego
