#pragma once

#include <vector>

#include <Eigen/Core>

namespace osgLego
{

/** The least limit of pulls at some points with which forces at these points have a given sum.
 *
 * Forces that press upwards are not limited. With the same pull at each point, the rest of the load has to lie within
 * the convex hull of the points: for each edge of the hull, the moment about the edge gives a limit.
 * @param load the vertical force, upwards, and its moments force * x and force * y.
 * @param points in any order.
 * @return newtons, at least 0; infinite if the points are on a line, or if the load is not finite. */
double findLeastPull(const Eigen::Vector3d& load, const std::vector<Eigen::Vector2d>& points);

} // namespace osgLego
