#pragma once

#include <osgLego/BuildingPlan.h>
#include <osgLego/StabilityReport.h>

#include <cmath>
#include <functional>

namespace osgLego
{

/** The direction from which a model is seen while it is built, before any quarter turn. */
struct BuildingView
{
    static constexpr double LEAST_ELEVATION = 10.0; //!< from lower, the studs would not be visible
    static constexpr double MOST_ELEVATION = 80.0;  //!< from higher, the layers would not be

    double azimuth = BuildingStep::AZIMUTH;     //!< degrees from the front to the right
    double elevation = BuildingStep::ELEVATION; //!< degrees above the horizon, LEAST_ELEVATION to MOST_ELEVATION

    /** Whether the azimuth is finite and the elevation in its range. */
    bool isValid() const
    {
        return std::isfinite(azimuth) && elevation >= LEAST_ELEVATION && elevation <= MOST_ELEVATION;
    }
    bool operator==(const BuildingView&) const = default;
};

/** How a building plan is made. */
struct PlanningOptions
{
    BuildingBase base = BuildingBase::TABLE;
    /** The view for which BuildingStep::turns are chosen. */
    BuildingView view;
    /** Whether the stability of the partial model is checked after every step, and parts are placed accordingly. In
     * large models, some steps remain unchecked, which bounds the time: see BuildingPlan::getNumUnchecked(). */
    bool checksStability = true;
    /** Called regularly, from any thread; planBuilding() returns null soon after it returns true. May be empty. */
    std::function<bool()> isCancelled;
    /** Called with the fraction done, 0 to 1, in one thread. May be empty. */
    std::function<void(double)> progress;
};

} // namespace osgLego
