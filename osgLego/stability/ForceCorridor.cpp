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

/** The sum of the forces of a joint that are selected, about its middle. */
template <typename Select>
Wrench sumForces(const EquilibriumProgram& program, const EquilibriumProgram::Joint& joint,
                 const Eigen::ArrayXd& forces, const Select& isSelected)
{
    Wrench sum = Wrench::Zero();
    for (std::size_t force = joint.first; force < joint.end; ++force)
        if (isSelected(program.getKind(force)))
            sum += forces[static_cast<Eigen::Index>(force)] * program.getWrench(force);
    return sum;
}

} // namespace

/** The parts of a corridor, and the forces on them. */
struct ForceCorridor::Program
{
    std::vector<std::uint32_t> parts;
    std::vector<Contact> contacts;   // those of `joints`, of `beside`, and with the base
    std::vector<Wrench> loads;       // for each part, of the forces that are kept
    std::vector<std::size_t> joints; // between the parts
    std::vector<std::size_t> beside; // contacts between the parts
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

void ForceCorridor::setBeside(std::vector<Contact> contacts)
{
    _beside = std::move(contacts);
    // Models with y upwards are mirrored in the graph.
    for (Contact& contact : _beside)
        if (_boxes[contact.lower].low[contact.kind] > _boxes[contact.upper].low[contact.kind])
            std::swap(contact.lower, contact.upper);
}

Eigen::Vector3d ForceCorridor::findCenter(std::uint32_t part) const
{
    return 0.5 * (toPitches(_boxes[part].low) + toPitches(_boxes[part].high));
}

/** The middle of the contact of two parts. */
Eigen::Vector3d ForceCorridor::findMiddle(std::uint32_t part, std::uint32_t other) const
{
    const PartBox& a = _boxes[part];
    const PartBox& b = _boxes[other];
    return 0.5 * (toPitches(glm::max(a.low, b.low)) + toPitches(glm::min(a.high, b.high)));
}

/** The force of a joint on its upper part, and its torque about the centre of a part. */
Wrench ForceCorridor::findWrench(const BearingForces& forces, std::size_t joint, std::uint32_t part) const
{
    const BearingJoints::Joint& own = _joints.getJoints()[joint];
    const Eigen::Vector3d center = findCenter(part);
    const Eigen::Vector3d place = findMiddle(own.lower, own.upper);
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
    addBeside(start, isInside, program);
    const auto base = _joints.getBase() == BuildingBase::TABLE ? Contact::TABLE : Contact::STUDS;
    for (const std::uint32_t part : program.parts)
        if (_joints.getGraph().isOnBase(part)) program.contacts.push_back({Contact::BASE, part, base});
    return program;
}

/** Add the contacts between parts of the corridor that are beside each other, and the forces of others that press on
 * it. */
void ForceCorridor::addBeside(const BearingForces& start, const std::vector<bool>& isInside, Program& program) const
{
    const auto addLoad = [&](std::size_t index, std::uint32_t part, double sign)
    {
        const Contact& contact = _beside[index];
        const Eigen::Vector3d arm = findMiddle(contact.lower, contact.upper) - findCenter(part);
        Wrench wrench = sign * start.beside[index];
        wrench.tail<3>() += arm.cross(Eigen::Vector3d(wrench.head<3>()));
        const auto place = std::lower_bound(program.parts.begin(), program.parts.end(), part);
        program.loads[static_cast<std::size_t>(place - program.parts.begin())] += wrench;
    };
    for (std::size_t index = 0; index < _beside.size(); ++index)
    {
        const Contact& contact = _beside[index];
        if (isInside[contact.lower] && isInside[contact.upper])
        {
            program.contacts.push_back(contact);
            program.beside.push_back(index);
        }
        else if (!start.beside.empty() && isInside[contact.upper])
            addLoad(index, contact.upper, 1.0);
        else if (!start.beside.empty() && isInside[contact.lower])
            addLoad(index, contact.lower, -1.0);
    }
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
    setForces(search.getProgram(), found->forces, own, forces);
    if (_joints.getBase() == BuildingBase::PLATE) forces.floorPull = std::max(forces.floorPull, found->tension);
    return forces;
}

/** Take over the forces between parts of a corridor, and those on the base. */
void ForceCorridor::setForces(const EquilibriumProgram& solved, const Eigen::ArrayXd& found, const Program& own,
                              BearingForces& forces) const
{
    auto solvedJoint = solved.getJoints().begin();
    for (const std::size_t index : own.joints)
    {
        const std::vector<double> pressures = findPressures(solved, *solvedJoint, found);
        const auto firstPoint = static_cast<std::ptrdiff_t>(_joints.getJoints()[index].firstPoint);
        std::copy(pressures.begin(), pressures.end(), forces.pressures.begin() + firstPoint);
        const Wrench sum = sumForces(solved, *solvedJoint, found,
                                     [](EquilibriumProgram::Kind kind) { return kind == EquilibriumProgram::FREE; });
        forces.sideways[index] = {sum[0], sum[1], sum[5]};
        ++solvedJoint;
    }
    const auto isAny = [](EquilibriumProgram::Kind) { return true; };
    if (!own.beside.empty()) forces.beside.resize(_beside.size(), Wrench::Zero());
    for (const std::size_t index : own.beside)
        forces.beside[index] = sumForces(solved, *solvedJoint++, found, isAny);
    for (; solvedJoint != solved.getJoints().end(); ++solvedJoint)
    {
        const std::uint32_t part = own.parts[static_cast<std::size_t>(solvedJoint->upper)];
        VerticalLoad& load = forces.floorLoads[part];
        load.setZero(); // a base plate bears its loads anyway, if those that are added are balanced
        if (_joints.getBase() == BuildingBase::PLATE) continue;
        const Wrench sum = sumForces(solved, *solvedJoint, found, isAny);
        const Eigen::Vector2d center = _joints.getCenter(part);
        load = {sum[2], sum[2] * center.x() - sum[4], sum[2] * center.y() + sum[3]};
    }
}

} // namespace osgLego
