#include <osgLego/stability/EquilibriumProgram.h>

#include <osgLego/stability/ContactPoints.h>

#include <algorithm>
#include <array>
#include <numeric>

#include <Eigen/Geometry>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

Eigen::Vector3d findCenter(const PartBox& box)
{
    return 0.5 * (toPitches(box.low) + toPitches(box.high));
}

/** Two opposite corners of the intersection of two boxes, in pitches. */
std::array<Eigen::Vector3d, 2> findOverlap(std::span<const PartBox> boxes, const Contact& contact)
{
    const PartBox& upper = boxes[contact.upper];
    PartBox lower = upper;
    if (contact.lower != Contact::BASE)
        lower = boxes[contact.lower];
    else
        lower.high.z = upper.low.z;
    return {toPitches(glm::max(lower.low, upper.low)), toPitches(glm::min(lower.high, upper.high))};
}

Wrench createWrench(const Eigen::Vector3d& point, const Eigen::Vector3d& force)
{
    Wrench wrench;
    wrench << force, point.cross(force);
    return wrench;
}

} // namespace

EquilibriumProgram::EquilibriumProgram(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                       std::span<const Contact> contacts, std::span<const std::uint32_t> bodies,
                                       std::span<const Wrench> given)
{
    std::vector<std::uint32_t> numbers(bodies.begin(), bodies.end());
    if (bodies.empty())
    {
        numbers.resize(parts.size());
        std::iota(numbers.begin(), numbers.end(), 0u);
    }
    addWeights(boxes, parts, numbers);
    for (std::size_t body = 0; body < given.size(); ++body)
        _load.segment<6>(6 * static_cast<Eigen::Index>(body)) -= given[body];
    const auto findBody = [&](std::uint32_t part)
    {
        const auto place = std::lower_bound(parts.begin(), parts.end(), part) - parts.begin();
        return static_cast<std::int32_t>(numbers[static_cast<std::size_t>(place)]);
    };
    for (const Contact& contact : contacts)
    {
        const std::array<Eigen::Vector3d, 2> corners = findOverlap(boxes, contact);
        const Eigen::Vector3d place = 0.5 * (corners[0] + corners[1]);
        Joint joint;
        joint.upper = findBody(contact.upper);
        joint.upperArm = place - _centers[static_cast<std::size_t>(joint.upper)];
        if (contact.lower != Contact::BASE)
        {
            joint.lower = findBody(contact.lower);
            joint.lowerArm = place - _centers[static_cast<std::size_t>(joint.lower)];
        }
        joint.first = _wrenches.size();
        addForces(boxes, contact, 0.5 * (corners[1] - corners[0]), place);
        joint.end = _wrenches.size();
        _joints.push_back(joint);
    }
}

/** Add the bodies, with the weights of their parts. */
void EquilibriumProgram::addWeights(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                    std::span<const std::uint32_t> bodies)
{
    _numBodies = bodies.empty() ? 0 : *std::max_element(bodies.begin(), bodies.end()) + std::size_t(1);
    _centers.assign(_numBodies, Eigen::Vector3d::Zero());
    std::vector<double> counts(_numBodies, 0.0);
    for (std::size_t index = 0; index < parts.size(); ++index)
    {
        _centers[bodies[index]] += findCenter(boxes[parts[index]]);
        counts[bodies[index]] += 1.0;
    }
    for (std::size_t body = 0; body < _numBodies; ++body)
        _centers[body] /= counts[body];
    _load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(getNumRows()));
    _sideTorques.assign(_numBodies, 0.0);
    for (std::size_t index = 0; index < parts.size(); ++index)
    {
        const PartBox& box = boxes[parts[index]];
        const double added = NEWTONS_PER_GRAM * box.addedMass;
        const double weight = NEWTONS_PER_GRAM * box.mass + added;
        const Eigen::Vector3d arm = findCenter(box) - _centers[bodies[index]];
        _load.segment<6>(6 * static_cast<Eigen::Index>(bodies[index])) += createWrench(arm, {0.0, 0.0, weight});
        _sideTorques[bodies[index]] += weight * arm.z() + added * (toPitches(box.high) - findCenter(box)).z();
    }
}

void EquilibriumProgram::addForces(std::span<const PartBox> boxes, const Contact& contact,
                                   const Eigen::Vector3d& halfSize, const Eigen::Vector3d& place)
{
    if (contact.kind == Contact::STUDS || contact.kind == Contact::ROUGH_STUDS)
    {
        const Eigen::Vector3d upper = findCenter(boxes[contact.upper]) - place;
        const glm::ivec3 size = boxes[contact.upper].high - boxes[contact.upper].low;
        addStuds(findStudPoints({halfSize.x(), halfSize.y()}, {upper.x(), upper.y()}, {size.x, size.y}), halfSize,
                 contact.kind == Contact::ROUGH_STUDS);
    }
    else if (contact.kind == Contact::ROUGH_TABLE)
        addFriction(halfSize);
    else
        addPressure(contact.kind, halfSize);
}

void EquilibriumProgram::addStuds(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector3d& halfSize,
                                  bool areRough)
{
    for (const Eigen::Vector2d& point : findHull(points))
        addForce(createWrench({point.x(), point.y(), 0.0}, Eigen::Vector3d::UnitZ()), PRESSURE);
    for (const Eigen::Vector2d& point : points)
        addForce(createWrench({point.x(), point.y(), 0.0}, -Eigen::Vector3d::UnitZ()), DRAG);
    // Studs press from within in all directions, which allows any horizontal force and, with a second stud, any torque.
    addForce(Wrench::Unit(0), FREE);
    addForce(Wrench::Unit(1), FREE);
    if (halfSize.head<2>().maxCoeff() > 0.5)
        addForce(Wrench::Unit(5), FREE);
    else if (areRough)
        for (const double lever : {TURNING_LEVER, -TURNING_LEVER})
            addForce(lever * Wrench::Unit(5), DRAG);
}

void EquilibriumProgram::addPressure(int axis, const Eigen::Vector3d& halfSize)
{
    const int other = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    for (const double a : {-halfSize[other], halfSize[other]})
        for (const double b : {-halfSize[third], halfSize[third]})
        {
            Eigen::Vector3d point = Eigen::Vector3d::Zero();
            point[other] = a;
            point[third] = b;
            addForce(createWrench(point, Eigen::Vector3d::Unit(axis)), PRESSURE);
        }
}

void EquilibriumProgram::addFriction(const Eigen::Vector3d& halfSize)
{
    // The sums of four inclined forces are the pressures with friction in all directions.
    for (const double x : {-halfSize.x(), halfSize.x()})
        for (const double y : {-halfSize.y(), halfSize.y()})
            for (const Eigen::Vector2d& side : {Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(-1.0, 0.0),
                                                Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(0.0, -1.0)})
                addForce(createWrench({x, y, 0.0}, {FRICTION * side.x(), FRICTION * side.y(), 1.0}), PRESSURE);
}

Eigen::VectorXd EquilibriumProgram::createSideLoad(const Eigen::Vector2d& direction) const
{
    Eigen::VectorXd load(_load.size());
    for (std::size_t body = 0; body < _numBodies; ++body)
    {
        const auto row = static_cast<Eigen::Index>(6 * body);
        const double weight = _load[row + 2];
        const double torque = _sideTorques[body];
        load.segment<6>(row) << -weight * direction.x(), -weight * direction.y(), 0.0, torque * direction.y(),
            -torque * direction.x(), 0.0;
    }
    return load;
}

void EquilibriumProgram::addForce(const Wrench& wrench, Kind kind)
{
    _wrenches.push_back(wrench);
    _kinds.push_back(kind);
    _numDrags += kind == DRAG;
}

void EquilibriumProgram::multiply(const Eigen::VectorXd& forces, Eigen::VectorXd& rows) const
{
    rows.setZero(static_cast<Eigen::Index>(getNumRows()));
    for (const Joint& joint : _joints)
    {
        Wrench sum = Wrench::Zero();
        for (std::size_t force = joint.first; force < joint.end; ++force)
            sum += forces[static_cast<Eigen::Index>(force)] * _wrenches[force];
        const Eigen::Vector3d push = sum.head<3>();
        const auto add = [&](std::int32_t body, const Eigen::Vector3d& arm, double sign)
        {
            rows.segment<3>(6 * body) += sign * push;
            rows.segment<3>(6 * body + 3) += sign * (sum.tail<3>() + arm.cross(push));
        };
        add(joint.upper, joint.upperArm, 1.0);
        if (joint.lower != NO_BODY) add(joint.lower, joint.lowerArm, -1.0);
    }
}

Wrench EquilibriumProgram::getVelocity(const Eigen::VectorXd& rows, std::int32_t body, const Eigen::Vector3d& arm)
{
    Wrench velocity = rows.segment<6>(6 * body);
    velocity.head<3>() += velocity.tail<3>().cross(arm);
    return velocity;
}

void EquilibriumProgram::multiplyTransposed(const Eigen::VectorXd& rows, Eigen::VectorXd& forces) const
{
    forces.resize(static_cast<Eigen::Index>(getNumForces()));
    for (const Joint& joint : _joints)
    {
        Wrench velocity = getVelocity(rows, joint.upper, joint.upperArm);
        if (joint.lower != NO_BODY) velocity -= getVelocity(rows, joint.lower, joint.lowerArm);
        for (std::size_t force = joint.first; force < joint.end; ++force)
            forces[static_cast<Eigen::Index>(force)] = _wrenches[force].dot(velocity);
    }
}

} // namespace osgLego
