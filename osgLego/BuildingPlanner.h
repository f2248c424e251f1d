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
    /** Whether the stability of the partial model is checked after every step, and parts are placed accordingly. */
    bool checksStability = true;
    /** Called now and then, from any thread; the plan is given up if it returns true. May be empty. */
    std::function<bool()> isCancelled;
    /** Called with the fraction done, 0 to 1, in one thread. May be empty. */
    std::function<void(double)> progress;
};

/** Plan the steps in which a model is built.
 *
 * Steps go from bottom to top. No part is placed where nothing holds it, as far as the model allows: parts that can
 * only hang from others become submodels together with those, which are built apart and attached from above. A step
 * has 5 to 10 parts where possible, and at most 12.
 *
 * Needs no GL context; may be called from any thread.
 * @param model with parts that are in getPartTypes(); without parts, the plan has no steps.
 * @return the same plan for any number of threads; null if it was cancelled. */
OSGLEGO_EXPORT osg::ref_ptr<const BuildingPlan> planBuilding(const BrickModel& model,
                                                             const PlanningOptions& options = {});

} // namespace osgLego
