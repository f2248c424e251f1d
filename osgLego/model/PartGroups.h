#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <cstdint>
#include <vector>

namespace osgLego
{

/** Groups of parts, as indices in ascending order, the largest first. */
using PartGroups = std::vector<std::vector<std::uint32_t>>;

/** The groups of parts that touch each other. @param members indices of parts, in ascending order. */
PartGroups findTouchingGroups(const LaidParts& parts, const std::vector<std::uint32_t>& members);

/** The groups of parts that joints connect and that can't be placed from bottom to top: no upward path of joints from
 * the lowest layer reaches them. */
PartGroups findHangingGroups(const LaidParts& parts);

} // namespace osgLego
