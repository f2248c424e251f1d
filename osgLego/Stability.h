#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/StabilityReport.h>

#include <functional>
#include <optional>

namespace osgLego
{

/** How stability is computed. */
struct StabilityOptions
{
    BuildingBase base = BuildingBase::TABLE;
    /** Called regularly, from any thread; computeStability() returns nothing soon after it returns true. May be
     * empty. */
    std::function<bool()> isCancelled;
};

/** Compute whether a model stands.
 *
 * Needs no GL context; may be called from any thread.
 * @param model with parts that are in getPartTypes(); a model without parts stands.
 * @return nothing if it was cancelled.
 * @throws std::bad_alloc if there is not enough memory, of which large solid models need most: 288 bytes for each pair
 * of parts that the factorization connects. */
OSGLEGO_EXPORT std::optional<StabilityReport> computeStability(const BrickModel& model,
                                                               const StabilityOptions& options = {});

} // namespace osgLego
