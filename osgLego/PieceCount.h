#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/StabilityReport.h>

#include <cstddef>

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

} // namespace osgLego
