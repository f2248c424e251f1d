#include <osgLego/stability/TippingAngle.h>

#include <osgLego/stability/ContactPoints.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace osgLego
{

namespace
{

/** The centre of mass, in pitches, above a table. */
Eigen::Vector3d findMassCenter(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts, int table)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double mass = 0.0;
    for (const std::uint32_t part : parts)
    {
        const PartBox& box = boxes[part];
        const Eigen::Vector3d low = toPitches(box.low);
        const Eigen::Vector3d high = toPitches(box.high);
        const Eigen::Vector3d top(0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), high.z());
        sum += 0.5 * box.mass * (low + high) + box.addedMass * top;
        mass += box.mass + box.addedMass;
    }
    return sum / mass - toPitches({0, 0, table});
}

} // namespace

double findTippingAngle(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts, int lowest)
{
    std::vector<Eigen::Vector2d> corners;
    for (const std::uint32_t part : parts)
    {
        const PartBox& box = boxes[part];
        if (box.low.z != lowest) continue;
        for (const int x : {box.low.x, box.high.x})
            for (const int y : {box.low.y, box.high.y})
                corners.emplace_back(x, y);
    }
    const std::vector<Eigen::Vector2d> hull = findHull(std::move(corners));
    const Eigen::Vector3d center = findMassCenter(boxes, parts, lowest);
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t corner = 0; corner < hull.size(); ++corner)
    {
        const Eigen::Vector2d edge = (hull[(corner + 1) % hull.size()] - hull[corner]).normalized();
        const Eigen::Vector2d way = center.head<2>() - hull[corner];
        distance = std::min(distance, edge.x() * way.y() - edge.y() * way.x());
    }
    return std::max(0.0, std::atan2(distance, center.z())) * 180.0 / std::numbers::pi;
}

} // namespace osgLego
