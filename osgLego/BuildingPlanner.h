#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/Export.h>
#include <osgLego/PlanningOptions.h>

#include <osg/ref_ptr>

namespace osgLego
{

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
