#pragma once

#include <osgLego/StabilityReport.h>
#include <osgLego/layout/LayoutProblem.h>

#include <functional>
#include <optional>

namespace osgLego
{

/** Compute whether a layout stands on a table.
 * @param problem of bricks or plates.
 * @return the report, in which parts have the indices that they have in `parts`; nothing if it was cancelled. */
std::optional<StabilityReport> computeStanding(const LayoutProblem& problem, const LaidParts& parts,
                                               const std::function<bool()>& isCancelled);

/** Whether a layout is more stable than another one: fewer of its parts fall or, if all stand, its margin is
 * greater. */
bool standsBetter(const StabilityReport& report, const StabilityReport& other);

} // namespace osgLego
