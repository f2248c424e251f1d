#pragma once

#include <osgLego/StabilityReport.h>
#include <osgLego/stability/JointGraph.h>
#include <osgLego/stability/Wrench.h>

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace osgLego
{

/** A vertical force and its moments: force, force * x, force * y, in newtons and studs. */
using VerticalLoad = Eigen::Vector3d;

/** The contact points of parts, at which vertical forces act, and the parts' weights.
 *
 * Immutable once created; every function may be called from any thread. */
class BearingJoints
{
public:
    /** Two parts that touch by studs. The pressure at a point is positive if it pushes the upper part upwards. */
    struct Joint
    {
        std::uint32_t lower = 0;
        std::uint32_t upper = 0;
        std::size_t firstPoint = 0; //!< an index into getPoints()
        std::size_t endPoint = 0;
    };

    /** @param graph must outlive this object.
     * @param weights of the parts, in newtons. */
    BearingJoints(const JointGraph& graph, std::vector<double> weights, BuildingBase base);

    const JointGraph& getGraph() const { return _graph; }
    BuildingBase getBase() const { return _base; }
    const std::vector<Joint>& getJoints() const { return _joints; }
    /** The joints of a part, as indices into getJoints(). */
    const std::vector<std::uint32_t>& getJointsOf(std::uint32_t part) const { return _jointsOf[part]; }
    /** The places of all contact points, in studs. */
    const std::vector<Eigen::Vector2d>& getPoints() const { return _points; }
    VerticalLoad getWeight(std::uint32_t part) const;
    Eigen::Vector2d getCenter(std::uint32_t part) const;
    /** The points at which the base bears a part that stands on it: the corners of the part on a table. */
    std::vector<Eigen::Vector2d> findFloorPoints(std::uint32_t part) const;
    /** Whether the base bears the load of a part that stands on it: a table only above the bottom of the part, and
     * studs within their capacity.
     * @param floorPull newtons of pull that the load does not contain. */
    bool bears(std::uint32_t part, const VerticalLoad& load, double floorPull) const;

private:
    void addPoints(const BuildingBox& overlap, const BuildingBox& upper, std::vector<Eigen::Vector2d>& points) const;

    const JointGraph& _graph;
    std::vector<double> _weights;
    BuildingBase _base;
    std::vector<Joint> _joints;
    std::vector<std::vector<std::uint32_t>> _jointsOf;
    std::vector<Eigen::Vector2d> _points;
};

/** Spread a load over points as evenly as possible: the least forces at the points whose sum is the load.
 * @param center near the points, for precision. @return nothing if no forces at these points have this sum. */
std::optional<std::vector<double>> spreadLoad(const VerticalLoad& load, const std::vector<Eigen::Vector2d>& points,
                                              const Eigen::Vector2d& center);

/** Forces that keep the parts in place in equilibrium. */
struct BearingForces
{
    /** The greatest pull at a contact point, also with a base plate, minus a margin for rounding errors. */
    static constexpr double CAPACITY = 0.999 * StabilityReport::CAPACITY;

    std::vector<bool> isPlaced;
    std::vector<double> pressures;        //!< for each contact point, in newtons
    std::vector<VerticalLoad> floorLoads; //!< for each part, on the base
    /** For each joint, the forces along x and y, and the torque about the vertical, about its middle. */
    std::vector<Eigen::Vector3d> sideways;
    /** For each contact of ForceCorridor::setBeside(), the force on `upper` and its torque about the middle of the
     * contact; empty if there are no such forces. */
    std::vector<Wrench> beside;
    double floorPull = 0.0; //!< the greatest pull at points of the base that `floorLoads` does not contain
};

/** Forces on no parts. */
BearingForces createNoForces(const BearingJoints& joints);

} // namespace osgLego
