#include <osgLego/BuildingPlanner.h>

#include <osgLego/building/PlanBuilder.h>

namespace osgLego
{

osg::ref_ptr<const BuildingPlan> planBuilding(const BrickModel& model, const PlanningOptions& options)
{
    if (options.isCancelled && options.isCancelled()) return nullptr;
    return PlanBuilder(model, options).build();
}

} // namespace osgLego
