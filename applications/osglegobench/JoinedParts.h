#pragma once

#include <osgLego/BrickModel.h>

#include <cstdint>
#include <vector>

namespace osgLego
{

/** For each part of a model, the parts to which studs join it. Found from contacts, apart from the planner's graph. */
std::vector<std::vector<std::uint32_t>> findJoinedParts(const BrickModel& model);

} // namespace osgLego
