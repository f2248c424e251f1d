#pragma once

#include <osgLego/StabilityReport.h>

#include <functional>

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

} // namespace osgLego
