#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/StabilityReport.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace osgLego
{

/** A weight that is put on the middle of the top of a part, and touches nothing else. */
struct AddedWeight
{
    std::uint32_t part = 0; //!< an index into BrickModel::getParts()
    double grams = 0.0;     //!< at least 0
};

/** How stability is computed. */
struct StabilityOptions
{
    BuildingBase base = BuildingBase::TABLE; //!< below the lowest parts
    /** Called regularly, from any thread; computeStability() returns nothing soon after it returns true. May be
     * empty. */
    std::function<bool()> isCancelled;
    std::vector<AddedWeight> weights = {}; //!< those of one part add up
    /** Whether StabilityReport::tiltAngles are found, which takes about five times as long. */
    bool findsTilt = false;
};

/** Compute whether a model of parts stands under its own weight and added weights, which parts fall otherwise, and how
 * much its joints bear. docs/stability.md has the physics, and times.
 *
 * Preconditions:
 * 1. Every part is in getPartTypes(): findPartType() gives its type. legolizeOnCpu() and LegoNode make no other parts,
 *    but BrickModel::createOfParts() accepts any box.
 * 2. Several threads may call StabilityOptions::isCancelled at once.
 *
 * Usage:
 *
 *     const osg::ref_ptr<const osgLego::BrickModel> model = lego->getBricks();
 *     osgLego::StabilityOptions options;
 *     options.base = osgLego::BuildingBase::PLATE;
 *     const std::optional<osgLego::StabilityReport> report = osgLego::computeStability(*model, options);
 *     if (report && !report->stands) std::cout << report->falling.size() << " parts fall\n";
 *
 * Uses no GL. May be called from any thread, and by several at a time; uses all threads that oneTBB gives the caller.
 * @param model a model without parts stands.
 * @return a report with an entry in StabilityReport::loads for each part; nothing if it was cancelled.
 * @throws std::invalid_argument if an added weight is on a part that does not exist, is negative or not finite.
 * @throws std::bad_alloc if there is not enough memory, of which large solid models need most: about 450 bytes for
 * each pair of parts that the factorization connects. */
OSGLEGO_EXPORT std::optional<StabilityReport> computeStability(const BrickModel& model,
                                                               const StabilityOptions& options = {});

} // namespace osgLego
