#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/StabilityReport.h>
#include <osgLego/layout/LayoutProblem.h>

#include <functional>
#include <optional>

#include <osg/ref_ptr>

namespace osgLego
{

/** The model of a layout in a grid with the axes of the layout. Its parts have the indices that they have in `parts`.
 * @param problem of bricks or plates. */
osg::ref_ptr<const BrickModel> createStandingModel(const LayoutProblem& problem, const LaidParts& parts);

/** Compute whether a layout stands on a table.
 * @param problem of bricks or plates.
 * @return the report, in which parts have the indices that they have in `parts`; nothing if it was cancelled. */
std::optional<StabilityReport> computeStanding(const LayoutProblem& problem, const LaidParts& parts,
                                               const std::function<bool()>& isCancelled);

/** Whether a layout is more stable than another one: fewer of its parts fall or, if all stand, its margin is
 * greater. */
bool standsBetter(const StabilityReport& report, const StabilityReport& other);

} // namespace osgLego
