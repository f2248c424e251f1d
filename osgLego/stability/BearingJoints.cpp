#include <osgLego/stability/BearingJoints.h>

#include <osgLego/stability/ContactPoints.h>

#include <utility>

#include <Eigen/Dense>
#include <glm/common.hpp>

namespace osgLego
{

namespace
{

Eigen::Vector2d toCenter(const BuildingBox& box)
{
    return 0.5 * Eigen::Vector2d(box.lower.x + box.upper.x, box.lower.y + box.upper.y);
}

} // namespace

BearingJoints::BearingJoints(const JointGraph& graph, std::vector<double> weights, BuildingBase base) :
    _graph(graph), _weights(std::move(weights)), _base(base), _jointsOf(graph.getNumParts())
{
    for (std::uint32_t lower = 0; lower < graph.getNumParts(); ++lower)
        for (const PartLink& link : graph.getJointsAbove(lower))
        {
            for (const std::uint32_t part : {lower, link.part})
                _jointsOf[part].push_back(static_cast<std::uint32_t>(_joints.size()));
            const BuildingBox& below = graph.getBox(lower);
            const BuildingBox& above = graph.getBox(link.part);
            const std::size_t first = _points.size();
            addPoints({glm::max(below.lower, above.lower), glm::min(below.upper, above.upper)}, above, _points);
            _joints.push_back({lower, link.part, first, _points.size()});
        }
}

void BearingJoints::addPoints(const BuildingBox& overlap, const BuildingBox& upper,
                              std::vector<Eigen::Vector2d>& points) const
{
    const Eigen::Vector2d place = toCenter(overlap);
    const glm::ivec3 size = overlap.upper - overlap.lower;
    const glm::ivec3 upperSize = upper.upper - upper.lower;
    for (const Eigen::Vector2d& point :
         findStudPoints({0.5 * size.x, 0.5 * size.y}, toCenter(upper) - place, {upperSize.x, upperSize.y}))
        points.push_back(place + point);
}

VerticalLoad BearingJoints::getWeight(std::uint32_t part) const
{
    const Eigen::Vector2d center = getCenter(part);
    return _weights[part] * VerticalLoad(1.0, center.x(), center.y());
}

Eigen::Vector2d BearingJoints::getCenter(std::uint32_t part) const
{
    return toCenter(_graph.getBox(part));
}

std::vector<Eigen::Vector2d> BearingJoints::findFloorPoints(std::uint32_t part) const
{
    const BuildingBox& box = _graph.getBox(part);
    std::vector<Eigen::Vector2d> points;
    if (_base == BuildingBase::PLATE)
        addPoints(box, box, points);
    else
        for (const int x : {box.lower.x, box.upper.x})
            for (const int y : {box.lower.y, box.upper.y})
                points.emplace_back(x, y);
    return points;
}

bool BearingJoints::bears(std::uint32_t part, const VerticalLoad& load, double floorPull) const
{
    if (_base == BuildingBase::PLATE)
    {
        const std::optional<std::vector<double>> pressures = spreadLoad(load, findFloorPoints(part), getCenter(part));
        return pressures &&
               std::all_of(pressures->begin(), pressures->end(),
                           [&](double pressure) { return pressure - floorPull >= -BearingForces::CAPACITY; });
    }
    constexpr double TOLERANCE = 1e-9; // newtons times the pitch
    const BuildingBox& box = _graph.getBox(part);
    const auto isWithin = [&load](double moment, int lower, int upper)
    { return moment >= lower * load[0] - TOLERANCE && moment <= upper * load[0] + TOLERANCE; };
    return isWithin(load[1], box.lower.x, box.upper.x) && isWithin(load[2], box.lower.y, box.upper.y);
}

std::optional<std::vector<double>> spreadLoad(const VerticalLoad& load, const std::vector<Eigen::Vector2d>& points,
                                              const Eigen::Vector2d& center)
{
    const auto toRow = [&center](const Eigen::Vector2d& point)
    { return Eigen::Vector3d(1.0, point.x() - center.x(), point.y() - center.y()); };
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector2d& point : points)
        sum += toRow(point) * toRow(point).transpose();
    const Eigen::Vector3d wanted(load[0], load[1] - load[0] * center.x(), load[2] - load[0] * center.y());
    const Eigen::Vector3d slopes = sum.ldlt().solve(wanted);
    constexpr double TOLERANCE = 1e-9; // newtons
    // Written so that NaN fails.
    if (!((sum * slopes - wanted).cwiseAbs().maxCoeff() <= TOLERANCE)) return std::nullopt;
    std::vector<double> forces;
    forces.reserve(points.size());
    for (const Eigen::Vector2d& point : points)
        forces.push_back(slopes.dot(toRow(point)));
    return forces;
}

BearingForces createNoForces(const BearingJoints& joints)
{
    const std::size_t numParts = joints.getGraph().getNumParts();
    return {std::vector<bool>(numParts, false),
            std::vector<double>(joints.getPoints().size(), 0.0),
            std::vector<VerticalLoad>(numParts, VerticalLoad::Zero()),
            std::vector<Eigen::Vector3d>(joints.getJoints().size(), Eigen::Vector3d::Zero()),
            {}};
}

} // namespace osgLego
