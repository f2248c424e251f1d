#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Stability.h>

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego::test
{

/** The least upper limit of drags with which a model is in equilibrium, in newtons, by COIN-OR's CLP: one linear
 * program with every contact point of docs/stability.md, and torques about the origin. Nothing if no limit suffices.
 * @param weights on the parts. */
std::optional<double> computePlainTension(const BrickModel& model, BuildingBase base,
                                          const std::vector<AddedWeight>& weights = {});

/** The tangent of the greatest angle by which the base can be tilted, at most 1, so that the model stands: by bisection
 * with linear programs with the true weights at each angle, and friction on a table of twice the pressure.
 * @param direction in which the base descends, along x or y. */
double computePlainTilt(const BrickModel& model, BuildingBase base, const glm::ivec2& direction,
                        const std::vector<AddedWeight>& weights = {});

} // namespace osgLego::test
