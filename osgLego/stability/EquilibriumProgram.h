#pragma once

#include <osgLego/stability/ContactFinder.h>
#include <osgLego/stability/Wrench.h>

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace osgLego
{

/** The forces that keep some parts in equilibrium, as the columns of a linear program.
 *
 * Parts may be joined to rigid bodies; otherwise each is a body of its own. Each body has six rows, its forces and its
 * torques about its centre. Each column is a force between two bodies: it acts on one, and its opposite on the other. A
 * force is at least 0; a force that holds, a drag, has an upper limit too. docs/stability.md describes the columns.
 * Those that can't change the optimum are omitted: pressure within the convex hull of the points of a contact, and
 * horizontal pressure between its outermost rows.
 *
 * Immutable once created; every function may be called from any thread. */
class EquilibriumProgram
{
public:
    static constexpr std::int32_t NO_BODY = -1; //!< the base
    static constexpr double NEWTONS_PER_GRAM = 9.8e-3;
    /** The greatest friction on a rough table, as a share of the pressure: nothing slides below 63 degrees. */
    static constexpr double FRICTION = 2.0;
    /** The lever, in pitches, of the friction that holds a part against turning about a single rough stud. The
     * friction is that of one contact point, up to the limit of drags. */
    static constexpr double TURNING_LEVER = 0.25;

    enum Kind : std::uint8_t
    {
        PRESSURE, //!< at least 0
        DRAG,     //!< between 0 and an upper limit that all drags share
        FREE      //!< any
    };

    /** The forces of one contact. */
    struct Joint
    {
        std::int32_t lower = NO_BODY; //!< a body; receives the opposite of each force
        std::int32_t upper = NO_BODY;
        Eigen::Vector3d lowerArm =
            Eigen::Vector3d::Zero(); //!< from the centre of `lower` to the place that the wrenches are about
        Eigen::Vector3d upperArm = Eigen::Vector3d::Zero();
        std::size_t first = 0; //!< column
        std::size_t end = 0;
    };

    /** @param contacts between parts in `parts` that are in different bodies, or with the base.
     * @param parts indices into `boxes`, in ascending order.
     * @param bodies for each part, the number of its body, from 0 on; if empty, each part is a body.
     * @param given for each body, a force that acts on it in any case, and its torque about the centre; if empty,
     * none. */
    EquilibriumProgram(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                       std::span<const Contact> contacts, std::span<const std::uint32_t> bodies = {},
                       std::span<const Wrench> given = {});

    std::size_t getNumBodies() const { return _numBodies; }
    std::size_t getNumRows() const { return 6 * _numBodies; }
    /** The place about which the torques of a body are, in pitches. */
    const Eigen::Vector3d& getCenter(std::size_t body) const { return _centers[body]; }
    std::size_t getNumForces() const { return _wrenches.size(); }
    /** In the order of the contacts. */
    const std::vector<Joint>& getJoints() const { return _joints; }
    /** The forces that are needed, in newtons: the weights of the parts, and those added, upwards. */
    const Eigen::VectorXd& getLoad() const { return _load; }
    /** The forces that are needed in addition if the base is tilted, for a tangent of the angle of 1.
     * @param direction horizontal, in which the base descends, of length 1. */
    Eigen::VectorXd createSideLoad(const Eigen::Vector2d& direction) const;
    const Wrench& getWrench(std::size_t force) const { return _wrenches[force]; }
    Kind getKind(std::size_t force) const { return _kinds[force]; }
    std::size_t getNumDrags() const { return _numDrags; }

    /** Compute the sum of the forces on each part. */
    void multiply(const Eigen::VectorXd& forces, Eigen::VectorXd& rows) const;
    /** The velocity of a body at a place. @param rows the velocities of all bodies at their centres, and their rates of
     * rotation. @param arm from the centre to the place. */
    static Wrench getVelocity(const Eigen::VectorXd& rows, std::int32_t body, const Eigen::Vector3d& arm);
    /** Compute the rate at which each force would do work if the parts moved. */
    void multiplyTransposed(const Eigen::VectorXd& rows, Eigen::VectorXd& forces) const;

private:
    void addWeights(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                    std::span<const std::uint32_t> bodies);
    void addForces(std::span<const PartBox> boxes, const Contact& contact, const Eigen::Vector3d& halfSize,
                   const Eigen::Vector3d& place);
    void addStuds(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector3d& halfSize, bool areRough);
    void addPressure(int axis, const Eigen::Vector3d& halfSize);
    void addFriction(const Eigen::Vector3d& halfSize);
    void addForce(const Wrench& wrench, Kind kind);

    std::size_t _numBodies = 0;
    std::vector<Eigen::Vector3d> _centers; //!< of the bodies: the means of those of their parts
    std::size_t _numDrags = 0;
    std::vector<Joint> _joints;
    std::vector<Wrench> _wrenches;
    std::vector<Kind> _kinds;
    Eigen::VectorXd _load;
    std::vector<double> _sideTorques; // of horizontal forces as large as the weights, about the centres
};

} // namespace osgLego
