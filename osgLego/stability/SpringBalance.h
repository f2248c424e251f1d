#pragma once

#include <osgLego/stability/BearingJoints.h>

#include <optional>
#include <span>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace osgLego
{

/** Finds forces between parts as if all contact points were equal springs, which spreads loads evenly.
 *
 * If the forces are within the capacity of the joints, the parts stand, as with WeightFlow. Springs that pull more are
 * made softer, and corners of parts that lift off a table are released, one group after the other.
 *
 * One thread. */
class SpringBalance
{
public:
    /** @param joints must outlive this object. */
    explicit SpringBalance(const BearingJoints& joints) : _joints(joints) {}

    /** Add parts to those that are in place.
     * @param start forces that are kept, to which those due to the new parts are added.
     * @param isPlaced those that are to be in place, which include all that are.
     * @param isInside those that pass on the weights of new parts: parts that are to be in place, with all new ones.
     * The forces between others are kept. Fewer parts take less time.
     * @return nothing if no forces within the capacity were found. */
    std::optional<BearingForces> add(const BearingForces& start, const std::vector<bool>& isPlaced,
                                     const std::vector<bool>& isInside);

private:
    /** A point at which the base bears a part. */
    struct FloorPoint
    {
        std::uint32_t part = 0;
        Eigen::Vector2d place;
        bool isReleased = false;
    };
    using FloorPoints = std::vector<FloorPoint>;

    void findFloorPoints();
    bool solveSprings(const std::vector<bool>& isKnown);
    double getForce(const BearingJoints::Joint& joint, std::size_t point) const;
    VerticalLoad getFloorLoad(const BearingForces& start, std::span<const FloorPoint> points) const;
    FloorPoints::const_iterator findNextPart(FloorPoints::const_iterator point) const;
    bool soften(const BearingForces& start);
    Eigen::Vector3d toRow(std::uint32_t part, const Eigen::Vector2d& place) const;
    double getDepth(std::uint32_t part, const Eigen::Vector2d& place) const;
    bool releaseFloor(const BearingForces& start);
    bool isBalanced() const;
    std::optional<BearingForces> createForces(const BearingForces& start, const std::vector<bool>& isPlaced) const;

    const BearingJoints& _joints;
    std::vector<bool> _isInside;
    std::vector<Eigen::Index> _rows; // for each part, the first of its rows
    FloorPoints _floor;              // ordered by part
    std::vector<double> _springs;    // the stiffness at each contact point
    Eigen::SparseMatrix<double> _stiffness;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> _factors;
    bool _hasPattern = false; // whether that of the stiffness was analyzed, which is the same for all springs
    Eigen::VectorXd _weights;
    Eigen::VectorXd _depths; // how far parts sink, and how they incline
};

} // namespace osgLego
