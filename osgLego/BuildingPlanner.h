#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/Export.h>
#include <osgLego/PlanningOptions.h>

#include <osg/ref_ptr>

namespace osgLego
{

/** Plan the steps in which a model is built by hand.
 *
 * Steps go from bottom to top, region by region. No part is placed where nothing holds it, or below others: parts that
 * hang are placed together with a part above them. More than two of these become submodels, which are built apart, some
 * of them upside down, and attached from above; submodels of more than 150 parts, or nested more than three deep, are
 * avoided by pressing hanging parts on from below, unless more steps had to be held by hand. Parts that no joints
 * connect to the lowest layer can't be placed; they come last. A step has 5 to 10 parts where possible, and at most 12,
 * a submodel counting as two; a step with submodels may have fewer. docs/building.md has the rules, and times.
 *
 * Preconditions:
 * 1. Every part is in getPartTypes(): findPartType() gives its type. legolizeOnCpu() and LegoNode make no other parts,
 *    but BrickModel::createOfParts() accepts any box.
 * 2. Several threads may call PlanningOptions::isCancelled at once.
 *
 * Usage:
 *
 *     const osg::ref_ptr<const osgLego::BrickModel> model = lego->getBricks();
 *     osgLego::PlanningOptions options;
 *     options.progress = [](double share) { std::cout << std::lround(100.0 * share) << " %\n"; };
 *     const osg::ref_ptr<const osgLego::BuildingPlan> plan = osgLego::planBuilding(*model, options);
 *     for (const osgLego::BuildingStep& step : plan->getSteps())
 *         std::cout << plan->getPlacedParts(step).size() << " parts\n";
 *     lego->setBuildingPlan(plan);
 *
 * Uses no GL. May be called from any thread, and by several at a time; uses all threads that oneTBB gives the caller.
 * @param model without parts, the plan has no steps.
 * @return the same plan for any number of threads; null if it was cancelled.
 * @throws std::bad_alloc if there is not enough memory. */
OSGLEGO_EXPORT osg::ref_ptr<const BuildingPlan> planBuilding(const BrickModel& model,
                                                             const PlanningOptions& options = {});

} // namespace osgLego
