#include <osgLego/stability/SpringBalance.h>

#include <algorithm>

namespace osgLego
{

namespace
{

constexpr double TOLERANCE = 1e-9; // newtons

} // namespace

std::optional<BearingForces> SpringBalance::add(const BearingForces& start, const std::vector<bool>& isPlaced,
                                                const std::vector<bool>& isInside)
{
    constexpr int MOST_RELEASES = 20;
    constexpr int MOST_SOFTER = 10;
    _isInside = isInside;
    _springs.assign(_joints.getPoints().size(), 1.0);
    _hasPattern = false;
    findFloorPoints();
    int numReleases = 0;
    int numSofter = 0;
    while (solveSprings(start.isPlaced))
    {
        if (_joints.getBase() == BuildingBase::TABLE && releaseFloor(start))
        {
            if (++numReleases == MOST_RELEASES) return std::nullopt;
        }
        else if (numSofter++ == MOST_SOFTER || !soften(start))
            return createForces(start, isPlaced);
    }
    return std::nullopt;
}

void SpringBalance::findFloorPoints()
{
    _floor.clear();
    for (std::uint32_t part = 0; part < _isInside.size(); ++part)
        if (_isInside[part] && _joints.getGraph().isOnBase(part))
            for (const Eigen::Vector2d& place : _joints.findFloorPoints(part))
                _floor.push_back({part, place});
}

/** The factors of a part's unknowns, its depth at the centre and its slopes, in its depth at a place. */
Eigen::Vector3d SpringBalance::toRow(std::uint32_t part, const Eigen::Vector2d& place) const
{
    const Eigen::Vector2d way = place - _joints.getCenter(part);
    return {1.0, way.x(), way.y()};
}

double SpringBalance::getDepth(std::uint32_t part, const Eigen::Vector2d& place) const
{
    return _depths.segment<3>(_rows[part]).dot(toRow(part, place));
}

/** Find the depths at which the springs bear the weights of parts that are not known. @return false if parts are
 * loose. */
bool SpringBalance::solveSprings(const std::vector<bool>& isKnown)
{
    _rows.assign(_isInside.size(), -1);
    Eigen::Index numRows = 0;
    for (std::size_t part = 0; part < _isInside.size(); ++part)
        if (_isInside[part]) _rows[part] = 3 * numRows++;
    if (numRows == 0) return false;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](std::uint32_t part, std::uint32_t other, const Eigen::Matrix3d& block)
    {
        if (_rows[part] < _rows[other]) return; // only the lower triangle is used
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                entries.emplace_back(_rows[part] + row, _rows[other] + column, block(row, column));
    };
    for (const BearingJoints::Joint& joint : _joints.getJoints())
    {
        if (!_isInside[joint.lower] || !_isInside[joint.upper]) continue;
        Eigen::Matrix3d lower = Eigen::Matrix3d::Zero();
        Eigen::Matrix3d upper = Eigen::Matrix3d::Zero();
        Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero(); // rows of the upper part
        for (std::size_t point = joint.firstPoint; point < joint.endPoint; ++point)
        {
            const Eigen::Vector3d lowerRow = toRow(joint.lower, _joints.getPoints()[point]);
            const Eigen::Vector3d upperRow = toRow(joint.upper, _joints.getPoints()[point]);
            lower += _springs[point] * lowerRow * lowerRow.transpose();
            upper += _springs[point] * upperRow * upperRow.transpose();
            mixed -= _springs[point] * upperRow * lowerRow.transpose();
        }
        add(joint.lower, joint.lower, lower);
        add(joint.upper, joint.upper, upper);
        add(joint.upper, joint.lower, mixed);
        add(joint.lower, joint.upper, mixed.transpose());
    }
    for (const FloorPoint& point : _floor)
        if (!point.isReleased)
            add(point.part, point.part, toRow(point.part, point.place) * toRow(point.part, point.place).transpose());
    _weights.setZero(3 * numRows);
    for (std::uint32_t part = 0; part < _isInside.size(); ++part)
        if (_isInside[part] && !isKnown[part]) _weights[_rows[part]] = _joints.getWeight(part)[0];
    _stiffness.resize(3 * numRows, 3 * numRows);
    _stiffness.setFromTriplets(entries.begin(), entries.end());
    if (!_hasPattern) _factors.analyzePattern(_stiffness);
    _hasPattern = true;
    _factors.factorize(_stiffness);
    if (_factors.info() != Eigen::Success) return false;
    _depths = _factors.solve(_weights);
    return isBalanced();
}

/** Whether the springs bear the weights; they do not if some part is loose. */
bool SpringBalance::isBalanced() const
{
    const Eigen::VectorXd rest = _stiffness.selfadjointView<Eigen::Lower>() * _depths - _weights;
    return _depths.allFinite() && rest.cwiseAbs().maxCoeff() <= TOLERANCE;
}

/** The force of a spring on the upper part of a joint. */
double SpringBalance::getForce(const BearingJoints::Joint& joint, std::size_t point) const
{
    const Eigen::Vector2d& place = _joints.getPoints()[point];
    return _springs[point] * (getDepth(joint.upper, place) - getDepth(joint.lower, place));
}

/** Soften springs that pull more than their capacity, so that they pull less and others more.
 * @return whether there were any. */
bool SpringBalance::soften(const BearingForces& start)
{
    constexpr double SHARE = 0.9;
    constexpr double LEAST = 1e-3;
    bool hasChanged = false;
    for (const BearingJoints::Joint& joint : _joints.getJoints())
    {
        if (!_isInside[joint.lower] || !_isInside[joint.upper]) continue;
        for (std::size_t point = joint.firstPoint; point < joint.endPoint; ++point)
        {
            const double force = getForce(joint, point);
            const double capacity = BearingForces::CAPACITY + start.pressures[point];
            if (force >= -capacity) continue;
            _springs[point] *= std::max(SHARE * capacity / -force, LEAST);
            hasChanged = true;
        }
    }
    return hasChanged;
}

/** The first point of the next part. */
SpringBalance::FloorPoints::const_iterator SpringBalance::findNextPart(FloorPoints::const_iterator point) const
{
    return std::find_if(point, _floor.end(),
                        [part = point->part](const FloorPoint& other) { return other.part != part; });
}

/** Release points of parts that lift off the table. @return whether there were any. */
bool SpringBalance::releaseFloor(const BearingForces& start)
{
    bool hasChanged = false;
    for (auto first = _floor.cbegin(); first != _floor.cend();)
    {
        const auto end = findNextPart(first);
        if (!_joints.bears(first->part, getFloorLoad(start, {first, end}), start.floorPull))
            for (auto index = first - _floor.cbegin(); index < end - _floor.cbegin(); ++index)
            {
                FloorPoint& point = _floor[static_cast<std::size_t>(index)];
                if (point.isReleased || getDepth(point.part, point.place) >= -TOLERANCE) continue;
                point.isReleased = true;
                hasChanged = true;
            }
        first = end;
    }
    return hasChanged;
}

/** The load of a part on the base. @param points all of the part. */
VerticalLoad SpringBalance::getFloorLoad(const BearingForces& start, std::span<const FloorPoint> points) const
{
    VerticalLoad load = start.floorLoads[points.front().part];
    for (const FloorPoint& point : points)
        if (!point.isReleased)
            load += getDepth(point.part, point.place) * VerticalLoad(1.0, point.place.x(), point.place.y());
    return load;
}

std::optional<BearingForces> SpringBalance::createForces(const BearingForces& start,
                                                         const std::vector<bool>& isPlaced) const
{
    BearingForces forces = start;
    forces.isPlaced = isPlaced;
    for (const BearingJoints::Joint& joint : _joints.getJoints())
    {
        if (!_isInside[joint.lower] || !_isInside[joint.upper]) continue;
        for (std::size_t point = joint.firstPoint; point < joint.endPoint; ++point)
        {
            forces.pressures[point] += getForce(joint, point);
            if (forces.pressures[point] < -BearingForces::CAPACITY) return std::nullopt;
        }
    }
    for (auto first = _floor.begin(); first != _floor.end();)
    {
        const auto end = findNextPart(first);
        VerticalLoad& load = forces.floorLoads[first->part];
        load = getFloorLoad(start, {first, end});
        if (!_joints.bears(first->part, load, start.floorPull)) return std::nullopt;
        first = end;
    }
    return forces;
}

} // namespace osgLego
