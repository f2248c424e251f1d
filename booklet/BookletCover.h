#pragma once

#include "BookletModel.h"

#include <osgLego/BuildingPlan.h>
#include <osgLego/Stability.h>

#include <optional>
#include <string>
#include <vector>

namespace osgLego
{

/** Sentences for the cover if a model can't be built as planned.
 * @param stability unset if it was not computed. */
std::vector<std::string> createWarnings(const BookletModel& model, const std::optional<StabilityReport>& stability,
                                        const BuildingPlan& plan, BuildingBase base);

} // namespace osgLego
