#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/StabilityReport.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** Count the pieces of a model of parts that no studs hold together. A base plate joins those that stand on it: its
 * studs hold them.
 *
 *     if (osgLego::countPieces(*model, osgLego::BuildingBase::PLATE) > 1) warn();
 *
 * Uses no GL. May be called from any thread.
 * @param model bricks that are not joined to parts do not count.
 * @return 0 for a model without parts. */
OSGLEGO_EXPORT std::size_t countPieces(const BrickModel& model, BuildingBase base);

/** Count the pieces of a model while it is built.
 *
 * May be called from any thread.
 * @param order different indices into BrickModel::getParts(), such as BuildingPlan::getOrder().
 * @return for each part in this order, the number of pieces when it is in place. */
OSGLEGO_EXPORT std::vector<std::size_t> countPiecesInOrder(const BrickModel& model,
                                                           std::span<const std::uint32_t> order, BuildingBase base);

} // namespace osgLego
