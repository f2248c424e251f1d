#pragma once

#include <osgLego/stability/BearingJoints.h>
#include <osgLego/stability/EquilibriumProgram.h>

#include <functional>
#include <optional>
#include <vector>

namespace osgLego
{

/** Adds parts to forces in equilibrium by a linear program of some parts, the corridor: the forces between others are
 * kept, and those on the corridor become loads.
 *
 * A solution is an equilibrium of all parts, so that they stand: each part outside has the same forces as before. If
 * none is found, the parts may stand nevertheless.
 *
 * One thread. */
class ForceCorridor
{
public:
    /** @param joints must outlive this object. @param cellPlates the height of a cell, in plates.
     * @param isCancelled may be empty. */
    ForceCorridor(const BearingJoints& joints, int cellPlates, std::function<bool()> isCancelled);

    /** @param contacts of parts beside each other, which press each other, in any order. Without them, forces are only
     * restricted. */
    void setBeside(std::vector<Contact> contacts);

    /** Add parts to those that are in place.
     * @param start forces in equilibrium.
     * @param isPlaced those that are to be in place, which include all that are.
     * @param isInside the corridor: parts in place, with all new ones.
     * @return nothing if no forces within the capacity were found. */
    std::optional<BearingForces> add(const BearingForces& start, const std::vector<bool>& isPlaced,
                                     const std::vector<bool>& isInside) const;

private:
    struct Program;

    Program createProgram(const BearingForces& start, const std::vector<bool>& isPlaced,
                          const std::vector<bool>& isInside) const;
    Eigen::Vector3d findCenter(std::uint32_t part) const;
    Eigen::Vector3d findMiddle(std::uint32_t part, std::uint32_t other) const;
    Wrench findWrench(const BearingForces& forces, std::size_t joint, std::uint32_t part) const;
    void addBeside(const BearingForces& start, const std::vector<bool>& isInside, Program& program) const;
    void setForces(const EquilibriumProgram& solved, const Eigen::ArrayXd& found, const Program& own,
                   BearingForces& forces) const;

    const BearingJoints& _joints;
    std::function<bool()> _isCancelled;
    std::vector<PartBox> _boxes;
    std::vector<Contact> _beside;
};

} // namespace osgLego
