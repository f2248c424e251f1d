#include <osgLego/stability/TensionBound.h>

#include <osgLego/stability/LeastPull.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace osgLego
{

namespace
{

// Tolerances of equations, relative to the weights: while the springs still change, and at last.
constexpr double LOOSE = 1e-3;
constexpr double TIGHT = 1e-9;
// The pull of a table that counts as none, and the sum of all residuals, in newtons, or newtons times the pitch: even
// if all were in one row, a fraction of the tolerance of EquilibriumSearch.
constexpr double NO_PULL = 1e-7;
constexpr double RESIDUAL_TOLERANCE = 5e-6;
// The stiffness of a point that pulls, relative to one that pushes, and the pull in newtons from which it becomes less.
constexpr double SOFTNESS = 0.1;
constexpr double MUCH_PULL = 0.1;
// The least size of a group of bodies, in pitches: about ten parts of a solid. In larger models, groups are larger, so
// that there are no more than a few thousand: the exact solution for them takes time with a power of their number.
constexpr double LEAST_GROUP_SIZE = 6.0;
constexpr double BODIES_OF_LEAST_GROUPS = 20'000.0;

using Vector2d = Eigen::Vector2d;

} // namespace

TensionBound::TensionBound(const EquilibriumProgram& program, std::function<bool()> isCancelled) :
    _program(program), _isCancelled(std::move(isCancelled)), _solver(createMovements())
{
    for (std::size_t joint = 0; joint < program.getJoints().size(); ++joint)
        addBearing(joint);
    _loads.resize(static_cast<Eigen::Index>(3 * program.getNumBodies()));
    for (Eigen::Index body = 0; 3 * body < _loads.size(); ++body)
    {
        const Wrench load = program.getLoad().segment<6>(6 * body);
        _loads.segment<3>(3 * body) << load[2], -load[4], load[3];
    }
    _sinking.setZero(_loads.size());
}

/** Add the points of a contact by studs, or with a table. */
void TensionBound::addBearing(std::size_t index)
{
    const EquilibriumProgram::Joint& joint = _program.getJoints()[index];
    Bearing bearing{index, joint.lower, joint.upper, joint.lowerArm.head<2>(), joint.upperArm.head<2>(), {}, {}};
    std::vector<Vector2d> corners;
    for (std::size_t force = joint.first; force < joint.end; ++force)
    {
        const Wrench& wrench = _program.getWrench(force);
        if (_program.getKind(force) == EquilibriumProgram::DRAG)
            bearing.points.emplace_back(wrench[4], -wrench[3]);
        else if (_program.getKind(force) == EquilibriumProgram::PRESSURE)
            corners.emplace_back(-wrench[4], wrench[3]);
    }
    bearing.canPull = !bearing.points.empty();
    if (!bearing.canPull)
    {
        if (joint.lower != EquilibriumProgram::NO_BODY) return; // beside each other
        bearing.points = std::move(corners);
    }
    bearing.pushes.assign(bearing.points.size(), true);
    bearing.softness = bearing.canPull ? SOFTNESS : 0.0;
    _bearings.push_back(std::move(bearing));
}

/** The movements of groups of bodies that are near each other: each sinks and inclines as a whole. */
TwoLevelSolver::Matrix TensionBound::createMovements() const
{
    const auto numBodies = static_cast<Eigen::Index>(_program.getNumBodies());
    const double size =
        LEAST_GROUP_SIZE * std::max(1.0, std::cbrt(static_cast<double>(numBodies) / BODIES_OF_LEAST_GROUPS));
    std::map<std::array<long, 3>, Eigen::Index> groups;
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<Vector2d> origins; // of the groups: their first bodies
    for (Eigen::Index body = 0; body < numBodies; ++body)
    {
        const Eigen::Vector3d& center = _program.getCenter(static_cast<std::size_t>(body));
        std::array<long, 3> place;
        for (std::size_t axis = 0; axis < place.size(); ++axis)
            place[axis] = std::lround(std::floor(center[static_cast<Eigen::Index>(axis)] / size));
        const auto [group, isNew] = groups.emplace(place, static_cast<Eigen::Index>(groups.size()));
        if (isNew) origins.push_back(center.head<2>());
        const Vector2d way = center.head<2>() - origins[static_cast<std::size_t>(group->second)];
        for (Eigen::Index row = 0; row < 3; ++row)
            entries.emplace_back(3 * body + row, 3 * group->second + row, 1.0);
        entries.emplace_back(3 * body, 3 * group->second + 1, way.x());
        entries.emplace_back(3 * body, 3 * group->second + 2, way.y());
    }
    TwoLevelSolver::Matrix movements(3 * numBodies, 3 * static_cast<Eigen::Index>(groups.size()));
    movements.setFromTriplets(entries.begin(), entries.end());
    return movements;
}

/** The factors of a body's unknowns in how far one of its points sinks. */
Eigen::Vector3d TensionBound::toRow(const Vector2d& arm, const Vector2d& point)
{
    return {1.0, arm.x() + point.x(), arm.y() + point.y()};
}

double TensionBound::getStiffness(const Bearing& bearing, std::size_t point) const
{
    return bearing.pushes[point] ? 1.0 : bearing.softness;
}

TwoLevelSolver::Matrix TensionBound::createMatrix() const
{
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&entries](std::int32_t body, std::int32_t other, const Eigen::Matrix3d& block)
    {
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                entries.emplace_back(3 * body + row, 3 * other + column, block(row, column));
    };
    for (const Bearing& bearing : _bearings)
    {
        Eigen::Matrix3d lower = Eigen::Matrix3d::Zero();
        Eigen::Matrix3d upper = Eigen::Matrix3d::Zero();
        Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero();
        for (std::size_t point = 0; point < bearing.points.size(); ++point)
        {
            const double stiffness = getStiffness(bearing, point);
            const Eigen::Vector3d lowerRow = toRow(bearing.lowerArm, bearing.points[point]);
            const Eigen::Vector3d upperRow = toRow(bearing.upperArm, bearing.points[point]);
            lower += stiffness * lowerRow * lowerRow.transpose();
            upper += stiffness * upperRow * upperRow.transpose();
            mixed -= stiffness * upperRow * lowerRow.transpose();
        }
        add(bearing.upper, bearing.upper, upper);
        if (bearing.lower == EquilibriumProgram::NO_BODY) continue;
        add(bearing.lower, bearing.lower, lower);
        add(bearing.upper, bearing.lower, mixed);
        add(bearing.lower, bearing.upper, mixed.transpose());
    }
    TwoLevelSolver::Matrix matrix(_loads.size(), _loads.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/** How much two bodies approach each other at a point. */
double TensionBound::getApproach(const Bearing& bearing, std::size_t point) const
{
    const auto getDepth = [&](std::int32_t body, const Vector2d& arm)
    { return _sinking.segment<3>(3 * body).dot(toRow(arm, bearing.points[point])); };
    const double lower = bearing.lower == EquilibriumProgram::NO_BODY ? 0.0 : getDepth(bearing.lower, bearing.lowerArm);
    return getDepth(bearing.upper, bearing.upperArm) - lower;
}

/** Find the least pulls with which the points have the forces of the springs. */
void TensionBound::findPulls()
{
    for (Bearing& bearing : _bearings)
    {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t point = 0; point < bearing.points.size(); ++point)
            sum += getStiffness(bearing, point) * getApproach(bearing, point) *
                   toRow(Vector2d::Zero(), bearing.points[point]);
        bearing.pull = findLeastPull(sum, bearing.points);
    }
}

double TensionBound::getMostPull() const
{
    double most = 0.0;
    for (const Bearing& bearing : _bearings)
        if (bearing.canPull) most = std::max(most, bearing.pull);
    return most;
}

/** Whether parts would lift off the table. */
bool TensionBound::isLifted() const
{
    return std::any_of(_bearings.begin(), _bearings.end(),
                       [](const Bearing& bearing) { return !bearing.canPull && bearing.pull > NO_PULL; });
}

bool TensionBound::solve(double tolerance)
{
    _matrix = createMatrix();
    return _solver.factorize(_matrix, _isCancelled) && _solver.solve(_loads, tolerance, _isCancelled, _sinking);
}

/** Make points stiff or soft, as they push or pull now, and joints that pull much softer. The mean of the old and the
 * new logarithm keeps the springs from alternating between two states. */
void TensionBound::adapt()
{
    for (Bearing& bearing : _bearings)
    {
        for (std::size_t point = 0; point < bearing.points.size(); ++point)
            bearing.pushes[point] = getApproach(bearing, point) >= 0.0;
        const double excess = bearing.pull / MUCH_PULL;
        if (bearing.canPull) bearing.softness = std::sqrt(bearing.softness * SOFTNESS / (1.0 + excess * excess));
    }
}

bool TensionBound::isBalanced() const
{
    const Eigen::VectorXd rest = _matrix * _sinking - _loads;
    return rest.allFinite() && rest.lpNorm<1>() <= RESIDUAL_TOLERANCE;
}

std::optional<std::vector<double>> TensionBound::find(double capacity)
{
    constexpr int MOST_STEPS = 20;
    constexpr int FIRST_STEPS = 4; // in which pulls may grow
    constexpr double HOPELESS = 4.0;
    constexpr double SAME = 0.01;
    double last = std::numeric_limits<double>::quiet_NaN();
    for (int step = 0; step < MOST_STEPS; ++step)
    {
        if (!solve(LOOSE)) break;
        findPulls();
        const double most = getMostPull();
        if (step >= FIRST_STEPS && !(most <= HOPELESS * capacity)) break;
        // At last, forces that still change are good enough.
        const bool isSettled = std::abs(most - last) <= SAME * last || step + 1 == MOST_STEPS;
        if (most <= capacity && !isLifted() && isSettled)
        {
            if (!solve(TIGHT)) break;
            findPulls();
            if (getMostPull() <= capacity && !isLifted() && isBalanced()) return listPulls();
        }
        last = most;
        adapt();
    }
    return std::nullopt;
}

std::vector<double> TensionBound::listPulls() const
{
    std::vector<double> pulls(_program.getJoints().size(), 0.0);
    for (const Bearing& bearing : _bearings)
        if (bearing.canPull) pulls[bearing.joint] = bearing.pull;
    return pulls;
}

} // namespace osgLego
