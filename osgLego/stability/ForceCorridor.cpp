#include <osgLego/stability/ForceCorridor.h>

#include <osgLego/stability/ContactPoints.h>
#include <osgLego/stability/EquilibriumSearch.h>

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <glm/common.hpp>

namespace osgLego
{

namespace
{

/** The pressures less the drags of a joint, at each of its points. */
std::vector<double> findPressures(const EquilibriumProgram& program, const EquilibriumProgram::Joint& joint,
                                  const Eigen::ArrayXd& forces)
{
    std::vector<Eigen::Vector2d> points;
    std::vector<double> pressures;
    const auto getPoint = [&](std::size_t force)
    {
        // The torques of a vertical force of 1 or -1.
        const Wrench wrench = program.getWrench(force) * program.getWrench(force)[2];
        return Eigen::Vector2d(-wrench[4], wrench[3]);
    };
    for (std::size_t force = joint.first; force < joint.end; ++force)
        if (program.getKind(force) == EquilibriumProgram::DRAG)
        {
            points.push_back(getPoint(force));
            pressures.push_back(-forces[static_cast<Eigen::Index>(force)]);
        }
    for (std::size_t force = joint.first; force < joint.end; ++force)
        if (program.getKind(force) == EquilibriumProgram::PRESSURE)
        {
            const auto place = std::find(points.begin(), points.end(), getPoint(force)) - points.begin();
            pressures[static_cast<std::size_t>(place)] += forces[static_cast<Eigen::Index>(force)];
        }
    return pressures;
}

/** The horizontal forces and the torque about the vertical of a joint. */
Eigen::Vector3d findSideways(const EquilibriumProgram& program, const EquilibriumProgram::Joint& joint,
                             const Eigen::ArrayXd& forces)
{
    Wrench sum = Wrench::Zero();
    for (std::size_t force = joint.first; force < joint.end; ++force)
        if (program.getKind(force) == EquilibriumProgram::FREE)
            sum += forces[static_cast<Eigen::Index>(force)] * program.getWrench(force);
    return {sum[0], sum[1], sum[5]};
}

} // namespace

/** The parts of a corridor, and the forces on them. */
struct ForceCorridor::Program
{
    std::vector<std::uint32_t> parts;
    std::vector<Contact> contacts;   // first those of `joints`
    std::vector<Wrench> loads;       // for each part, of the forces that are kept
    std::vector<std::size_t> joints; // between the parts
};

ForceCorridor::ForceCorridor(const BearingJoints& joints, int cellPlates, std::function<bool()> isCancelled) :
    _joints(joints), _isCancelled(std::move(isCancelled))
{
    for (std::uint32_t part = 0; part < joints.getGraph().getNumParts(); ++part)
    {
        const BuildingBox& box = joints.getGraph().getBox(part);
        const glm::ivec3 scale(1, 1, cellPlates);
        _boxes.push_back(
            {box.lower * scale, box.upper * scale, joints.getWeight(part)[0] / EquilibriumProgram::NEWTONS_PER_GRAM});
    }
}

Eigen::Vector3d ForceCorridor::findCenter(std::uint32_t part) const
{
    return 0.5 * (toPitches(_boxes[part].low) + toPitches(_boxes[part].high));
}

/** The force of a joint on its upper part, and its torque about the centre of a part. */
Wrench ForceCorridor::findWrench(const BearingForces& forces, std::size_t joint, std::uint32_t part) const
{
    const BearingJoints::Joint& own = _joints.getJoints()[joint];
    const Eigen::Vector3d center = findCenter(part);
    const PartBox& lower = _boxes[own.lower];
    const PartBox& upper = _boxes[own.upper];
    const Eigen::Vector3d place =
        0.5 * (toPitches(glm::max(lower.low, upper.low)) + toPitches(glm::min(lower.high, upper.high)));
    Wrench wrench = Wrench::Zero();
    const auto add = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& force)
    {
        wrench.head<3>() += force;
        wrench.tail<3>() += (point - center).cross(force);
    };
    for (std::size_t point = own.firstPoint; point < own.endPoint; ++point)
    {
        const Eigen::Vector2d& at = _joints.getPoints()[point];
        add({at.x(), at.y(), place.z()}, {0.0, 0.0, forces.pressures[point]});
    }
    const Eigen::Vector3d& sideways = forces.sideways[joint];
    add(place, {sideways[0], sideways[1], 0.0});
    wrench[5] += sideways[2];
    return wrench;
}

ForceCorridor::Program ForceCorridor::createProgram(const BearingForces& start, const std::vector<bool>& isPlaced,
                                                    const std::vector<bool>& isInside) const
{
    Program program;
    for (std::uint32_t part = 0; part < isInside.size(); ++part)
    {
        if (!isInside[part]) continue;
        program.parts.push_back(part);
        Wrench& load = program.loads.emplace_back(Wrench::Zero());
        for (const std::uint32_t index : _joints.getJointsOf(part))
        {
            const BearingJoints::Joint& joint = _joints.getJoints()[index];
            const std::uint32_t other = joint.lower == part ? joint.upper : joint.lower;
            if (isPlaced[other] && !isInside[other])
                load += (joint.upper == part ? 1.0 : -1.0) * findWrench(start, index, part);
            if (!isInside[other] || joint.lower != part) continue;
            program.contacts.push_back({part, other, Contact::STUDS});
            program.joints.push_back(index);
        }
    }
    const auto base = _joints.getBase() == BuildingBase::TABLE ? Contact::TABLE : Contact::STUDS;
    for (const std::uint32_t part : program.parts)
        if (_joints.getGraph().isOnBase(part)) program.contacts.push_back({Contact::BASE, part, base});
    return program;
}

std::optional<BearingForces> ForceCorridor::add(const BearingForces& start, const std::vector<bool>& isPlaced,
                                                const std::vector<bool>& isInside) const
{
    const Program own = createProgram(start, isPlaced, isInside);
    if (own.contacts.empty()) return std::nullopt;
    EquilibriumSearch search(_boxes, own.parts, own.contacts, _isCancelled, {}, own.loads);
    const std::optional<Equilibrium> found = search.findComplete(BearingForces::CAPACITY);
    if (!found) return std::nullopt;
    BearingForces forces = start;
    forces.isPlaced = isPlaced;
    const EquilibriumProgram& program = search.getProgram();
    for (std::size_t index = 0; index < own.joints.size(); ++index)
    {
        const EquilibriumProgram::Joint& joint = program.getJoints()[index];
        const std::vector<double> pressures = findPressures(program, joint, found->forces);
        std::copy(pressures.begin(), pressures.end(),
                  forces.pressures.begin() +
                      static_cast<std::ptrdiff_t>(_joints.getJoints()[own.joints[index]].firstPoint));
        forces.sideways[own.joints[index]] = findSideways(program, joint, found->forces);
    }
    for (const std::uint32_t part : own.parts)
        forces.floorLoads[part].setZero(); // the base bears its loads anyway, if those that are added are balanced
    if (_joints.getBase() == BuildingBase::PLATE) forces.floorPull = std::max(forces.floorPull, found->tension);
    return forces;
}

} // namespace osgLego
