#include <osgLego/stability/LeastPull.h>

#include <osgLego/stability/ContactPoints.h>

#include <algorithm>
#include <limits>

namespace osgLego
{

double findLeastPull(const Eigen::Vector3d& load, const std::vector<Eigen::Vector2d>& points)
{
    constexpr double UNLIMITED = std::numeric_limits<double>::infinity();
    const std::vector<Eigen::Vector2d> hull = findHull(points);
    if (hull.size() < 3 || !load.allFinite()) return UNLIMITED;
    const auto numPoints = static_cast<double>(points.size());
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points)
        sum += point;
    double pull = std::max(0.0, -load[0] / numPoints);
    for (std::size_t corner = 0; corner < hull.size(); ++corner)
    {
        const Eigen::Vector2d& start = hull[corner];
        const Eigen::Vector2d way = hull[(corner + 1) % hull.size()] - start;
        const Eigen::Vector2d inwards(-way.y(), way.x());
        // The moments about the edge of the load, and of one newton of pull at each point.
        const double moment = inwards.dot(load.tail<2>() - load[0] * start);
        const double helps = inwards.dot(sum - numPoints * start);
        pull = std::max(pull, helps > 0.0 ? -moment / helps : UNLIMITED);
    }
    return pull;
}

} // namespace osgLego
