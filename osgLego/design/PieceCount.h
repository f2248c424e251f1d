#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/StabilityReport.h>

#include <cstddef>

namespace osgLego
{

/** Count the pieces of a model of parts that no studs hold together. A base plate joins those that stand on it: its
 * studs hold them. */
std::size_t countPieces(const BrickModel& model, BuildingBase base);

} // namespace osgLego
