#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Stability.h>

#include <optional>
#include <vector>

namespace osgLego::test
{

/** The least upper limit of drags with which a model is in equilibrium, in newtons, by COIN-OR's CLP: one linear
 * program with every contact point of docs/stability.md, and torques about the origin. Nothing if no limit suffices.
 * @param weights on the parts. */
std::optional<double> computePlainTension(const BrickModel& model, BuildingBase base,
                                          const std::vector<AddedWeight>& weights = {});

} // namespace osgLego::test
