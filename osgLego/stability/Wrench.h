#pragma once

#include <Eigen/Core>

namespace osgLego
{

/** A force in newtons and its torque in newtons times the pitch of studs: x, y, z, about x, about y, about z. */
using Wrench = Eigen::Matrix<double, 6, 1>;

} // namespace osgLego
