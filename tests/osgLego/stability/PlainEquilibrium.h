#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Stability.h>

#include <optional>

namespace osgLego::test
{

/** The least upper limit of drags with which a model is in equilibrium, in newtons, by COIN-OR's CLP: one linear
 * program with every contact point of docs/stability.md, and torques about the origin. Nothing if no limit suffices. */
std::optional<double> computePlainTension(const BrickModel& model, BuildingBase base);

} // namespace osgLego::test
