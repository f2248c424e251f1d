#include <osgLego/stability/InteriorPointSolver.h>

#include <algorithm>
#include <cmath>

namespace osgLego
{

namespace
{

constexpr int MAXIMUM_ITERATIONS = 100;
// Proximal terms, which keep the equations well-conditioned: they slow down the steps of forces and of velocities, but
// vanish together with the steps.
constexpr double PRESSURE_INERTIA = 1e-8;
constexpr double FREE_INERTIA = 1e-3;
constexpr double VELOCITY_INERTIA = 1e-7;

// The share of the way to the nearest boundary that a step may take.
constexpr double STEP_SHARE = 0.995;

constexpr double ROW_TOLERANCE = 1e-8;   // newtons
constexpr double FORCE_TOLERANCE = 1e-5; // of the dual equations
constexpr double GAP_TOLERANCE = 1e-8;   // of the goal, relative above 1

using Places = std::vector<std::pair<std::int32_t, std::int32_t>>;

/** The parts of the contacts between two parts. */
Places findPlaces(const EquilibriumProgram& program)
{
    Places places;
    for (const EquilibriumProgram::Joint& joint : program.getJoints())
        if (joint.lower != EquilibriumProgram::NO_BODY) places.emplace_back(joint.upper, joint.lower);
    return places;
}

/** The matrix that moves the place about which wrenches are to the origin of `arm`. */
BlockCholesky::Block createShift(const Eigen::Vector3d& arm)
{
    BlockCholesky::Block shift = BlockCholesky::Block::Identity();
    shift(3, 1) = -arm.z();
    shift(3, 2) = arm.y();
    shift(4, 0) = arm.z();
    shift(4, 2) = -arm.x();
    shift(5, 0) = -arm.y();
    shift(5, 1) = arm.x();
    return shift;
}

/** The largest share of a step, at most 1e10, that keeps all values positive. */
double findLength(const Eigen::ArrayXd& values, const Eigen::ArrayXd& step)
{
    double reciprocal = 1e-10;
    for (Eigen::Index index = 0; index < values.size(); ++index)
        reciprocal = std::max(reciprocal, -step[index] / values[index]);
    return 1.0 / reciprocal;
}

} // namespace

InteriorPointSolver::InteriorPointSolver(const EquilibriumProgram& program, const std::function<bool()>& isCancelled) :
    _program(program), _cholesky(program.getNumBodies(), findPlaces(program), isCancelled),
    _isDrag(static_cast<Eigen::Index>(program.getNumForces())), _isSigned(_isDrag.size())
{
    for (Eigen::Index force = 0; force < _isDrag.size(); ++force)
    {
        const EquilibriumProgram::Kind kind = program.getKind(static_cast<std::size_t>(force));
        _isDrag[force] = kind == EquilibriumProgram::DRAG ? 1.0 : 0.0;
        _isSigned[force] = kind == EquilibriumProgram::FREE ? 0.0 : 1.0;
    }
}

std::optional<Equilibrium> InteriorPointSolver::solve(const EquilibriumGoal& goal)
{
    _goal = goal;
    if (_program.getNumDrags() == 0) _goal.minimizesTension = false;
    if (!_cholesky.isCancelled()) start();
    if (_cholesky.isCancelled()) return std::nullopt;
    Equilibrium result;
    for (findErrors(); !(result.hasConverged = hasConverged()) && result.numIterations < MAXIMUM_ITERATIONS;
         findErrors())
    {
        factorize();
        if (_cholesky.isCancelled()) return std::nullopt;
        findStep(findProducts(0.0));
        const auto [primal, dual] = findLengths();
        const double gap = computeGap(_point);
        const double reached = computeGap(advance(std::min(primal, 1.0), std::min(dual, 1.0)));
        const double center = std::pow(reached / gap, 3.0);
        Products products = findProducts(center * gap / _numProducts);
        products.forces -= _step.forces * _step.costs;
        products.slacks -= _step.slacks * _step.prices;
        products.lacks -= _step.lacks * _step.lackCosts;
        products.excesses -= _step.excesses * _step.excessCosts;
        products.tension -= _step.tensionSlack * _step.tensionPrice;
        findStep(products);
        const auto [primalLength, dualLength] = findLengths();
        _point = advance(std::min(STEP_SHARE * primalLength, 1.0), std::min(STEP_SHARE * dualLength, 1.0));
        ++result.numIterations;
    }
    result.forces = _point.forces;
    result.residuals = _point.lacks - _point.excesses;
    result.prices = _point.prices;
    result.tension = _point.tension;
    return result;
}

void InteriorPointSolver::start()
{
    const auto numRows = static_cast<Eigen::Index>(_program.getNumRows());
    _point.tension = _goal.minimizesTension ? 0.5 * _goal.capacity : _goal.capacity;
    _point.velocities = Eigen::ArrayXd::Zero(numRows);
    startForces();
    const double target = 0.5 * _point.tension / std::max(_isDrag.sum(), 1.0);
    _divisors = _isSigned * _point.forces + (1.0 - _isSigned);
    _point.costs = _isSigned * target / _divisors;
    _point.slacks = _isDrag * (_point.tension - _point.forces) + (1.0 - _isDrag);
    _point.prices = _isDrag * target / _point.slacks;
    _point.lackCosts = Eigen::ArrayXd::Constant(numRows, _goal.penalty);
    _point.excessCosts = _point.lackCosts;
    Eigen::VectorXd rows;
    _program.multiply(_point.forces.matrix(), rows);
    rows = _program.getLoad() - rows;
    _point.lacks = target / _point.lackCosts + rows.array().max(0.0);
    _point.excesses = target / _point.lackCosts - rows.array().min(0.0);
    _point.tensionSlack = _goal.minimizesTension ? _goal.capacity - _point.tension : 1.0;
    _point.tensionPrice = _goal.minimizesTension ? target / _point.tensionSlack : 0.0;
    _numProducts =
        _isSigned.sum() + static_cast<double>(2 * numRows) + _isDrag.sum() + (_goal.minimizesTension ? 1.0 : 0.0);
}

void InteriorPointSolver::startForces()
{
    // Drags of half the tension, the pressure that balances them, and the least change of both that carries the weight.
    Eigen::ArrayXd& forces = _point.forces;
    forces = _isDrag * (0.5 * _point.tension) + (1.0 - _isDrag);
    for (const EquilibriumProgram::Joint& joint : _program.getJoints())
    {
        const auto first = static_cast<Eigen::Index>(joint.first);
        const auto count = static_cast<Eigen::Index>(joint.end - joint.first);
        const double numDrags = _isDrag.segment(first, count).sum();
        const double numPressures = _isSigned.segment(first, count).sum() - numDrags;
        const double pressure = numDrags > 0.0 ? 0.5 * _point.tension * numDrags / numPressures : 0.1;
        for (Eigen::Index force = first; force < first + count; ++force)
            if (_isSigned[force] > 0.0 && _isDrag[force] == 0.0) forces[force] = pressure;
    }
    _weights = forces.square();
    _rowWeights = Eigen::ArrayXd::Constant(static_cast<Eigen::Index>(_program.getNumRows()), 1e-6);
    const Eigen::ArrayXd wanted = forces * _isSigned;
    factorizeRows();
    if (_cholesky.isCancelled()) return;
    Eigen::VectorXd rows, change;
    _program.multiply(wanted.matrix(), rows);
    rows = _program.getLoad() - rows;
    _cholesky.solve(rows);
    _program.multiplyTransposed(rows, change);
    change.array() *= _weights;
    forces = wanted + change.array();
    forces = (_isSigned > 0.0).select(forces.max(0.1 * wanted), forces);
    forces = (_isDrag > 0.0).select(forces.min(0.9 * _point.tension), forces);
}

void InteriorPointSolver::findErrors()
{
    _program.multiply(_point.forces.matrix(), _rowErrors);
    _rowErrors = _program.getLoad() - _rowErrors - (_point.lacks - _point.excesses).matrix();
    _program.multiplyTransposed(_point.velocities.matrix(), _forceErrors);
    _forceErrors =
        (EquilibriumGoal::FORCE_COST * _isSigned - _forceErrors.array() - _point.costs + _point.prices).matrix();
    _tensionError = _goal.minimizesTension ? 1.0 - _point.prices.sum() + _point.tensionPrice : 0.0;
}

double InteriorPointSolver::computeGap(const Point& point) const
{
    return (point.forces * point.costs).sum() + (point.slacks * point.prices).sum() +
           (point.lacks * point.lackCosts).sum() + (point.excesses * point.excessCosts).sum() +
           point.tensionSlack * point.tensionPrice;
}

bool InteriorPointSolver::hasConverged() const
{
    const double goal = _goal.penalty * (_point.lacks + _point.excesses).sum() + _point.tension;
    // Where newtons are missing, the cost of forces matters less.
    const double forceTolerance = FORCE_TOLERANCE * std::min(1.0 + goal, 10.0);
    return _rowErrors.lpNorm<Eigen::Infinity>() <= ROW_TOLERANCE &&
           _forceErrors.lpNorm<Eigen::Infinity>() <= forceTolerance && std::abs(_tensionError) <= FORCE_TOLERANCE &&
           computeGap(_point) <= GAP_TOLERANCE * (1.0 + goal);
}

void InteriorPointSolver::factorize()
{
    _slackWeights = _point.prices / _point.slacks;
    _divisors = _point.forces * _isSigned + (1.0 - _isSigned);
    _weights = 1.0 / (_point.costs / _divisors + _slackWeights + PRESSURE_INERTIA * _isSigned +
                      FREE_INERTIA * (1.0 - _isSigned));
    _rowWeights = _point.lacks / _point.lackCosts + _point.excesses / _point.excessCosts + VELOCITY_INERTIA;
    factorizeRows();
    if (!_goal.minimizesTension || _cholesky.isCancelled()) return;
    _program.multiply((_weights * _slackWeights).matrix(), _tensionColumn);
    _tensionSolution = _tensionColumn;
    solveRows(_tensionSolution);
}

void InteriorPointSolver::factorizeRows()
{
    _cholesky.setZero();
    for (std::size_t body = 0; body < _program.getNumBodies(); ++body)
        _cholesky.getDiagonal(body).diagonal() = _rowWeights.segment<6>(6 * static_cast<Eigen::Index>(body));
    std::size_t place = 0;
    for (const EquilibriumProgram::Joint& joint : _program.getJoints())
    {
        BlockCholesky::Block sum = BlockCholesky::Block::Zero();
        for (std::size_t force = joint.first; force < joint.end; ++force)
        {
            const Wrench& wrench = _program.getWrench(force);
            sum.noalias() += (_weights[static_cast<Eigen::Index>(force)] * wrench) * wrench.transpose();
        }
        const BlockCholesky::Block upper = createShift(joint.upperArm);
        const BlockCholesky::Block shifted = upper * sum;
        _cholesky.getDiagonal(static_cast<std::size_t>(joint.upper)) += shifted * upper.transpose();
        if (joint.lower == EquilibriumProgram::NO_BODY) continue;
        const BlockCholesky::Block lower = createShift(joint.lowerArm);
        _cholesky.getDiagonal(static_cast<std::size_t>(joint.lower)) += lower * sum * lower.transpose();
        _cholesky.setBlock(place++, -shifted * lower.transpose());
    }
    _cholesky.factorize();
}

void InteriorPointSolver::solveRows(Eigen::VectorXd& rows) const
{
    const Eigen::VectorXd right = rows;
    _cholesky.solve(rows);
    // The matrix is ill-conditioned near the end, so that the solution needs refinement.
    Eigen::VectorXd forces;
    Eigen::VectorXd error;
    _program.multiplyTransposed(rows, forces);
    forces.array() *= _weights;
    _program.multiply(forces, error);
    error = right - error - (_rowWeights * rows.array()).matrix();
    _cholesky.solve(error);
    rows += error;
}

InteriorPointSolver::Products InteriorPointSolver::findProducts(double target) const
{
    Products products;
    products.forces = _isSigned * target - _point.forces * _point.costs;
    products.slacks = _isDrag * target - _point.slacks * _point.prices;
    products.lacks = target - _point.lacks * _point.lackCosts;
    products.excesses = target - _point.excesses * _point.excessCosts;
    products.tension = _goal.minimizesTension ? target - _point.tensionSlack * _point.tensionPrice : 0.0;
    return products;
}

void InteriorPointSolver::findStep(const Products& products)
{
    const Eigen::ArrayXd shift = _forceErrors.array() - products.forces / _divisors + products.slacks / _point.slacks;
    Eigen::VectorXd rows;
    _program.multiply((_weights * shift).matrix(), rows);
    rows += _rowErrors;
    rows.array() += products.excesses / _point.excessCosts - products.lacks / _point.lackCosts;
    solveRows(rows);
    _step.tension = 0.0;
    if (_goal.minimizesTension)
    {
        const double right = (products.slacks / _point.slacks).sum() - products.tension / _point.tensionSlack -
                             (_slackWeights * _weights * shift).sum() - _tensionError;
        const double diagonal =
            (_slackWeights * _weights * _point.costs / _divisors).sum() + _point.tensionPrice / _point.tensionSlack;
        _step.tension = (right + _tensionColumn.dot(rows)) / (diagonal + _tensionColumn.dot(_tensionSolution));
        rows -= _step.tension * _tensionSolution;
    }
    _step.velocities = rows.array();
    Eigen::VectorXd rates;
    _program.multiplyTransposed(rows, rates);
    _step.forces = _weights * (rates.array() + _slackWeights * _step.tension - shift);
    _step.costs = (products.forces - _point.costs * _step.forces) / _divisors;
    _step.slacks = _isDrag * (_step.tension - _step.forces);
    _step.prices = (products.slacks - _point.prices * _step.slacks) / _point.slacks;
    _step.lackCosts = -_step.velocities;
    _step.lacks = (products.lacks - _point.lacks * _step.lackCosts) / _point.lackCosts;
    _step.excessCosts = _step.velocities;
    _step.excesses = (products.excesses - _point.excesses * _step.excessCosts) / _point.excessCosts;
    _step.tensionSlack = -_step.tension;
    _step.tensionPrice = (products.tension - _point.tensionPrice * _step.tensionSlack) / _point.tensionSlack;
}

std::pair<double, double> InteriorPointSolver::findLengths() const
{
    double primal = std::min({findLength(_divisors, _isSigned * _step.forces), findLength(_point.slacks, _step.slacks),
                              findLength(_point.lacks, _step.lacks), findLength(_point.excesses, _step.excesses)});
    double dual =
        std::min({findLength(_point.costs + (1.0 - _isSigned), _step.costs),
                  findLength(_point.prices + (1.0 - _isDrag), _step.prices),
                  findLength(_point.lackCosts, _step.lackCosts), findLength(_point.excessCosts, _step.excessCosts)});
    if (_goal.minimizesTension)
    {
        primal = std::min(primal, 1.0 / std::max(1e-10, -_step.tensionSlack / _point.tensionSlack));
        dual = std::min(dual, 1.0 / std::max(1e-10, -_step.tensionPrice / _point.tensionPrice));
    }
    return {primal, dual};
}

InteriorPointSolver::Point InteriorPointSolver::advance(double primal, double dual) const
{
    Point point;
    point.forces = _point.forces + primal * _step.forces;
    point.slacks = _point.slacks + primal * _step.slacks;
    point.lacks = _point.lacks + primal * _step.lacks;
    point.excesses = _point.excesses + primal * _step.excesses;
    point.tension = _point.tension + primal * _step.tension;
    point.tensionSlack = _point.tensionSlack + primal * _step.tensionSlack;
    point.costs = _point.costs + dual * _step.costs;
    point.prices = _point.prices + dual * _step.prices;
    point.lackCosts = _point.lackCosts + dual * _step.lackCosts;
    point.excessCosts = _point.excessCosts + dual * _step.excessCosts;
    point.velocities = _point.velocities + dual * _step.velocities;
    point.tensionPrice = _point.tensionPrice + dual * _step.tensionPrice;
    return point;
}

} // namespace osgLego
