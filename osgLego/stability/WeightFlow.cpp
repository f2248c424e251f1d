#include <osgLego/stability/WeightFlow.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <Eigen/Dense>

namespace osgLego
{

/** One addition. */
class WeightFlow::Pass
{
public:
    Pass(const WeightFlow& flow, BearingForces forces, const std::vector<bool>& isPlaced) :
        _flow(flow), _joints(flow._joints), _graph(_joints.getGraph()), _isPlaced(isPlaced), _forces(std::move(forces)),
        _distances(isPlaced.size(), UNREACHED), _loads(isPlaced.size(), VerticalLoad::Zero())
    {
        for (std::uint32_t part = 0; part < isPlaced.size(); ++part)
            if (isPlaced[part] && !_forces.isPlaced[part]) _loads[part] = _joints.getWeight(part);
        _forces.isPlaced = isPlaced;
        findSupported();
        findHanging();
    }

    bool add()
    {
        for (auto part = _hanging.rbegin(); part != _hanging.rend(); ++part)
            if (!passOn(*part)) return false;
        return std::all_of(_flow._fromTop.begin(), _flow._fromTop.end(),
                           [this](std::uint32_t part)
                           { return !_isPlaced[part] || _distances[part] > 0 || passOn(part); }) &&
               isComplete();
    }

    BearingForces take() { return std::move(_forces); }

private:
    static constexpr std::uint32_t UNREACHED = std::numeric_limits<std::uint32_t>::max();

    /** Parts on upward paths of joints from the base have the distance 0. */
    void findSupported()
    {
        for (auto part = _flow._fromTop.rbegin(); part != _flow._fromTop.rend(); ++part)
        {
            if (!_isPlaced[*part]) continue;
            const auto below = _graph.getJointsBelow(*part);
            const bool isSupported =
                _graph.isOnBase(*part) || std::any_of(below.begin(), below.end(),
                                                      [this](const PartLink& joint)
                                                      { return _isPlaced[joint.part] && _distances[joint.part] == 0; });
            if (isSupported) _distances[*part] = 0;
        }
    }

    /** Find the distances of other parts from these, by joints, and list them in this order. */
    void findHanging()
    {
        for (const std::uint32_t part : _flow._fromTop)
            if (_isPlaced[part] && _distances[part] == 0) reachFrom(part);
        for (std::size_t index = 0; index < _hanging.size(); ++index)
            reachFrom(_hanging[index]);
    }

    void reachFrom(std::uint32_t part)
    {
        for (const std::uint32_t joint : _joints.getJointsOf(part))
        {
            const std::uint32_t other = getOther(_joints.getJoints()[joint], part);
            if (!_isPlaced[other] || _distances[other] != UNREACHED) continue;
            _distances[other] = _distances[part] + 1;
            _hanging.push_back(other);
        }
    }

    bool isComplete() const
    {
        for (std::uint32_t part = 0; part < _isPlaced.size(); ++part)
            if (_isPlaced[part] && _distances[part] == UNREACHED) return false;
        return true;
    }

    static std::uint32_t getOther(const BearingJoints::Joint& joint, std::uint32_t part)
    {
        return joint.lower == part ? joint.upper : joint.lower;
    }

    /** Whether a part passes its load on to another. */
    bool leadsOn(std::uint32_t part, std::uint32_t other) const
    {
        if (!_isPlaced[other]) return false;
        if (_distances[part] > 0) return _distances[other] < _distances[part];
        return _distances[other] == 0 && _graph.getBox(other).lower.z < _graph.getBox(part).lower.z;
    }

    /** Spread the load of a part over the joints that bear it. @return whether they can. */
    bool passOn(std::uint32_t part)
    {
        const VerticalLoad load = _loads[part];
        if (load.isZero(0.0)) return true;
        if (_graph.isOnBase(part)) return addToFloor(part, load);
        std::vector<Eigen::Vector2d> points;
        visitBearing(part, [&](const BearingJoints::Joint&, std::size_t point)
                     { points.push_back(_joints.getPoints()[point]); });
        const std::optional<std::vector<double>> forces = spreadLoad(load, points, _joints.getCenter(part));
        if (!forces) return false;
        auto next = forces->begin();
        bool isWithin = true;
        visitBearing(part,
                     [&](const BearingJoints::Joint& joint, std::size_t point)
                     {
                         const Eigen::Vector2d& place = _joints.getPoints()[point];
                         const double force = *next++;
                         double& pressure = _forces.pressures[point];
                         pressure += joint.upper == part ? force : -force;
                         isWithin = isWithin && pressure >= -BearingForces::CAPACITY;
                         _loads[getOther(joint, part)] += force * VerticalLoad(1.0, place.x(), place.y());
                     });
        return isWithin;
    }

    template <typename Visitor>
    void visitBearing(std::uint32_t part, const Visitor& visit) const
    {
        for (const std::uint32_t index : _joints.getJointsOf(part))
        {
            const BearingJoints::Joint& joint = _joints.getJoints()[index];
            if (!leadsOn(part, getOther(joint, part))) continue;
            for (std::size_t point = joint.firstPoint; point < joint.endPoint; ++point)
                visit(joint, point);
        }
    }

    bool addToFloor(std::uint32_t part, const VerticalLoad& load)
    {
        return _joints.bears(part, _forces.floorLoads[part] += load, _forces.floorPull);
    }

    const WeightFlow& _flow;
    const BearingJoints& _joints;
    const JointGraph& _graph;
    const std::vector<bool>& _isPlaced;
    BearingForces _forces;
    std::vector<std::uint32_t> _distances;
    std::vector<VerticalLoad> _loads;
    std::vector<std::uint32_t> _hanging; // the nearest first
};

WeightFlow::WeightFlow(const BearingJoints& joints) : _joints(joints), _fromTop(joints.getGraph().getNumParts())
{
    const JointGraph& graph = joints.getGraph();
    std::iota(_fromTop.begin(), _fromTop.end(), 0u);
    std::stable_sort(_fromTop.begin(), _fromTop.end(),
                     [&graph](std::uint32_t a, std::uint32_t b)
                     { return graph.getBox(a).lower.z > graph.getBox(b).lower.z; });
}

bool WeightFlow::add(BearingForces& forces, const std::vector<bool>& isPlaced) const
{
    Pass pass(*this, forces, isPlaced);
    if (!pass.add()) return false;
    forces = pass.take();
    return true;
}

} // namespace osgLego
