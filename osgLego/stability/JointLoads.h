#pragma once

#include <osgLego/stability/EquilibriumProgram.h>

#include <span>
#include <vector>

namespace osgLego
{

/** For each body, the largest pull at its joints, as a share of StabilityReport::CAPACITY.
 * @param pulls newtons at a contact point, for each joint of the program. */
std::vector<float> findLoads(const EquilibriumProgram& program, std::span<const double> pulls);

} // namespace osgLego
