#include <osgLego/stability/InteriorPointSolver.h>

#include <algorithm>
#include <cmath>

namespace osgLego
{

namespace
{

constexpr int MAXIMUM_ITERATIONS = 100;
// The share of the way to the nearest boundary that a step may take.
constexpr double STEP_SHARE = 0.995;

// The products of variables and their dual slacks at the start, as a share of the mean cost of the residuals.
constexpr double START_SHARE = 0.1;

constexpr double ROW_TOLERANCE = 1e-8; // newtons
constexpr double LONG_STEP = 0.95;     // share of the step

/** Changes of products that bring those at the end of a step near to a target. */
Eigen::ArrayXd findCorrection(const Eigen::ArrayXd& reached, double target)
{
    constexpr double SPREAD = 10.0;
    return (reached.max(target / SPREAD).min(target * SPREAD) - reached).max(-target * SPREAD);
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
    _program(program), _rows(program, isCancelled), _isDrag(static_cast<Eigen::Index>(program.getNumForces())),
    _isSigned(_isDrag.size())
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
    constexpr int MOST_CORRECTIONS = 2;
    constexpr double SMALL_GAP = 1e-2; // of the goal, relative above 1
    _goal = goal;
    _velocityInertia = goal.inertia.velocities;
    chooseParameter();
    if (!_rows.isCancelled()) start();
    if (_rows.isCancelled()) return std::nullopt;
    Equilibrium result;
    findErrors();
    while (!(result.hasConverged = hasConverged()) && result.numIterations < MAXIMUM_ITERATIONS)
    {
        if ((result.isMissingCertain = isMissingCertain())) break;
        factorize();
        if (_rows.isCancelled()) return std::nullopt;
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
        products.parameter -= _step.parameterSlack * _step.parameterPrice;
        findStep(products);
        for (int round = 0; round < MOST_CORRECTIONS && improveStep(products, center * gap / _numProducts);)
            ++round;
        const auto [primalLength, dualLength] = findLengths();
        _point = advance(std::min(STEP_SHARE * primalLength, 1.0), std::min(STEP_SHARE * dualLength, 1.0));
        ++result.numIterations;
        const double previousError = _rowErrors.lpNorm<Eigen::Infinity>();
        findErrors();
        if (gap < SMALL_GAP * (1.0 + computeGoal()) && primalLength >= LONG_STEP) easeVelocities(previousError);
    }
    result.forces = _point.forces;
    result.residuals = _point.lacks - _point.excesses;
    result.velocities = _point.velocities;
    result.prices = _point.prices;
    result.tension = _parameter.limit + _parameter.limitRate * _point.parameter;
    if (_goal.tilt) result.tilt = _point.parameter;
    if (!result.hasConverged && !result.isMissingCertain) result.isBalanced = balance(result);
    if (_rows.isCancelled()) return std::nullopt;
    return result;
}

/** Let velocities grow faster if a long step has not brought the forces nearer to equilibrium.
 *
 * The inertia of velocities acts like residuals without a penalty. Where a small force at a long lever is missing, the
 * velocities grow by no more than (that force) / inertia in a step, and may need hundreds of steps to reach the
 * penalty. @param previousError the largest error of the rows before the step. */
void InteriorPointSolver::easeVelocities(double previousError)
{
    constexpr double LEAST_INERTIA = 1e-12;
    const double error = _rowErrors.lpNorm<Eigen::Infinity>();
    if (error > ROW_TOLERANCE && error > 0.5 * previousError)
        _velocityInertia = std::max(0.1 * _velocityInertia, LEAST_INERTIA);
}

/** Bring forces into equilibrium by the least changes, relative to their distances from the bounds, for the same
 * tension and tilt. @return whether all forces are within their bounds, and nothing is missing. */
bool InteriorPointSolver::balance(Equilibrium& result)
{
    constexpr int MOST_ROUNDS = 5;
    constexpr double TOLERANCE = 1e-9; // newtons: in sum, little for 20,000 parts
    const Eigen::VectorXd load = _program.getLoad() + _point.parameter * _parameter.load;
    Eigen::ArrayXd& forces = result.forces;
    for (int round = 0; forces.isFinite().all(); ++round)
    {
        const Eigen::ArrayXd above = (result.tension - forces) * _isDrag + (1.0 - _isDrag) * forces.abs();
        const Eigen::ArrayXd distances = (_isSigned > 0.0).select(forces.min(above), forces.abs().max(1.0));
        if (!(distances.minCoeff() >= 0.0)) return false;
        Eigen::VectorXd rows;
        _program.multiply(forces.matrix(), rows);
        rows = load - rows;
        if (rows.lpNorm<Eigen::Infinity>() <= TOLERANCE)
        {
            result.residuals.setZero();
            return true;
        }
        if (round == MOST_ROUNDS) return false;
        _weights = distances.square();
        _rows.factorize(_weights, Eigen::ArrayXd::Constant(rows.size(), 1e-12));
        if (_rows.isCancelled()) return false;
        _rows.solve(rows);
        Eigen::VectorXd change;
        _program.multiplyTransposed(rows, change);
        forces += _weights * change.array();
    }
    return false;
}

void InteriorPointSolver::chooseParameter()
{
    _parameter = {};
    _parameter.limit = _goal.capacity;
    _parameter.load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(_program.getNumRows()));
    if (_goal.tilt)
    {
        _parameter.isFree = true;
        _parameter.cost = -1.0;
        _parameter.most = _goal.tilt->most;
        _parameter.limitRate = _goal.tilt->capacityRate;
        _parameter.load = _goal.tilt->sideLoad;
    }
    else if (_goal.minimizesTension && _program.getNumDrags() > 0)
    {
        _parameter.isFree = true;
        _parameter.cost = _goal.tensionCost;
        _parameter.most = _goal.capacity;
        _parameter.limit = 0.0;
        _parameter.limitRate = 1.0;
    }
}

void InteriorPointSolver::start()
{
    const auto numRows = static_cast<Eigen::Index>(_program.getNumRows());
    _point.parameter = _parameter.isFree ? 0.5 * _parameter.most : 0.0;
    const double tension = _parameter.limit + _parameter.limitRate * _point.parameter;
    _point.velocities = Eigen::ArrayXd::Zero(numRows);
    startForces(tension);
    Eigen::VectorXd rows;
    _program.multiply(_point.forces.matrix(), rows);
    rows = _program.getLoad() + _point.parameter * _parameter.load - rows;
    // Residuals that are missing cost the penalty. If the other products were far smaller, the first steps would end at
    // once at the bounds of their variables.
    const double missing = rows.size() > 0 ? rows.lpNorm<1>() / static_cast<double>(rows.size()) : 0.0;
    const double target = std::max(0.5 * tension / std::max(_isDrag.sum(), 1.0), START_SHARE * _goal.penalty * missing);
    _divisors = _isSigned * _point.forces + (1.0 - _isSigned);
    _point.costs = _isSigned * target / _divisors;
    _point.slacks = _isDrag * (tension - _point.forces) + (1.0 - _isDrag);
    _point.prices = _isDrag * target / _point.slacks;
    _point.lackCosts = Eigen::ArrayXd::Constant(numRows, _goal.penalty);
    _point.excessCosts = _point.lackCosts;
    _point.lacks = target / _point.lackCosts + rows.array().max(0.0);
    _point.excesses = target / _point.lackCosts - rows.array().min(0.0);
    _point.parameterSlack = _parameter.isFree ? _parameter.most - _point.parameter : 1.0;
    _point.parameterPrice = _parameter.isFree ? target / _point.parameterSlack : 0.0;
    _numProducts = _isSigned.sum() + static_cast<double>(2 * numRows) + _isDrag.sum() + (_parameter.isFree ? 1.0 : 0.0);
}

void InteriorPointSolver::startForces(double tension)
{
    // Drags of half the tension, the pressure that balances them, and the least change of both that carries the weight.
    Eigen::ArrayXd& forces = _point.forces;
    forces = _isDrag * (0.5 * tension) + (1.0 - _isDrag);
    for (const EquilibriumProgram::Joint& joint : _program.getJoints())
    {
        const auto first = static_cast<Eigen::Index>(joint.first);
        const auto count = static_cast<Eigen::Index>(joint.end - joint.first);
        const double numDrags = _isDrag.segment(first, count).sum();
        const double numPressures = _isSigned.segment(first, count).sum() - numDrags;
        const double pressure = numDrags > 0.0 ? 0.5 * tension * numDrags / numPressures : 0.1;
        for (Eigen::Index force = first; force < first + count; ++force)
            if (_isSigned[force] > 0.0 && _isDrag[force] == 0.0) forces[force] = pressure;
    }
    _weights = forces.square();
    _rowWeights = Eigen::ArrayXd::Constant(static_cast<Eigen::Index>(_program.getNumRows()), 1e-6);
    const Eigen::ArrayXd wanted = forces * _isSigned;
    _rows.factorize(_weights, _rowWeights);
    if (_rows.isCancelled()) return;
    Eigen::VectorXd rows, change;
    _program.multiply(wanted.matrix(), rows);
    rows = _program.getLoad() + _point.parameter * _parameter.load - rows;
    _rows.solve(rows);
    _program.multiplyTransposed(rows, change);
    change.array() *= _weights;
    forces = wanted + change.array();
    forces = (_isSigned > 0.0).select(forces.max(0.1 * wanted), forces);
    forces = (_isDrag > 0.0).select(forces.min(0.9 * tension), forces);
}

void InteriorPointSolver::findErrors()
{
    _program.multiply(_point.forces.matrix(), _rowErrors);
    _rowErrors = _program.getLoad() + _point.parameter * _parameter.load - _rowErrors -
                 (_point.lacks - _point.excesses).matrix();
    _program.multiplyTransposed(_point.velocities.matrix(), _forceErrors);
    _forceErrors = (_goal.forceCost * _isSigned - _forceErrors.array() - _point.costs + _point.prices).matrix();
    _parameterError = _parameter.isFree ? _parameter.cost + _parameter.load.dot(_point.velocities.matrix()) -
                                              _parameter.limitRate * _point.prices.sum() + _point.parameterPrice
                                        : 0.0;
}

double InteriorPointSolver::computeGap(const Point& point) const
{
    return (point.forces * point.costs).sum() + (point.slacks * point.prices).sum() +
           (point.lacks * point.lackCosts).sum() + (point.excesses * point.excessCosts).sum() +
           point.parameterSlack * point.parameterPrice;
}

/** Whether the dual variables prove that the goal is out of reach without residuals, which cost far more than any
 * tension. */
bool InteriorPointSolver::isMissingCertain() const
{
    constexpr double CLEARLY = 10.0;
    if (!_goal.endsIfMissing || _forceErrors.lpNorm<Eigen::Infinity>() > findForceTolerance()) return false;
    const double errors =
        std::abs(_rowErrors.dot(_point.velocities.matrix())) + std::abs(_forceErrors.dot(_point.forces.matrix()));
    return computeGoal() - computeGap(_point) - errors > CLEARLY * (1.0 + _goal.capacity);
}

/** Where newtons are missing, the cost of forces matters less. */
double InteriorPointSolver::findForceTolerance() const
{
    return _goal.forceTolerance * std::min(1.0 + computeGoal(), 10.0);
}

double InteriorPointSolver::computeGoal() const
{
    return _goal.penalty * (_point.lacks + _point.excesses).sum() + std::abs(_parameter.cost * _point.parameter);
}

bool InteriorPointSolver::hasConverged() const
{
    const double goal = computeGoal();
    return _rowErrors.lpNorm<Eigen::Infinity>() <= ROW_TOLERANCE &&
           _forceErrors.lpNorm<Eigen::Infinity>() <= findForceTolerance() &&
           std::abs(_parameterError) <= _goal.forceTolerance && computeGap(_point) <= _goal.gapTolerance * (1.0 + goal);
}

void InteriorPointSolver::factorize()
{
    _slackWeights = _point.prices / _point.slacks;
    _divisors = _point.forces * _isSigned + (1.0 - _isSigned);
    _weights = 1.0 / (_point.costs / _divisors + _slackWeights + _goal.inertia.pressures * _isSigned +
                      _goal.inertia.freeForces * (1.0 - _isSigned));
    _rowWeights = _point.lacks / _point.lackCosts + _point.excesses / _point.excessCosts + _velocityInertia;
    _rows.factorize(_weights, _rowWeights);
    if (!_parameter.isFree || _rows.isCancelled()) return;
    _program.multiply((_weights * _slackWeights).matrix(), _parameterColumn);
    _parameterColumn = _parameter.limitRate * _parameterColumn - _parameter.load;
    _parameterSolution = _parameterColumn;
    _rows.solve(_parameterSolution);
}

InteriorPointSolver::Products InteriorPointSolver::findProducts(double target) const
{
    Products products;
    products.forces = _isSigned * target - _point.forces * _point.costs;
    products.slacks = _isDrag * target - _point.slacks * _point.prices;
    products.lacks = target - _point.lacks * _point.lackCosts;
    products.excesses = target - _point.excesses * _point.excessCosts;
    products.parameter = _parameter.isFree ? target - _point.parameterSlack * _point.parameterPrice : 0.0;
    return products;
}

void InteriorPointSolver::findStep(const Products& products)
{
    const Eigen::ArrayXd shift = _forceErrors.array() - products.forces / _divisors + products.slacks / _point.slacks;
    Eigen::VectorXd rows;
    _program.multiply((_weights * shift).matrix(), rows);
    rows += _rowErrors;
    rows.array() += products.excesses / _point.excessCosts - products.lacks / _point.lackCosts;
    _rows.solve(rows);
    const double limitRate = _parameter.limitRate;
    _step.parameter = 0.0;
    if (_parameter.isFree)
    {
        const double right =
            limitRate * ((products.slacks / _point.slacks).sum() - (_slackWeights * _weights * shift).sum()) -
            products.parameter / _point.parameterSlack - _parameterError;
        const double diagonal = limitRate * limitRate * (_slackWeights * _weights * _point.costs / _divisors).sum() +
                                _point.parameterPrice / _point.parameterSlack;
        _step.parameter = (right + _parameterColumn.dot(rows)) / (diagonal + _parameterColumn.dot(_parameterSolution));
        rows -= _step.parameter * _parameterSolution;
    }
    _step.velocities = rows.array();
    Eigen::VectorXd rates;
    _program.multiplyTransposed(rows, rates);
    _step.forces = _weights * (rates.array() + limitRate * _step.parameter * _slackWeights - shift);
    _step.costs = (products.forces - _point.costs * _step.forces) / _divisors;
    _step.slacks = _isDrag * (limitRate * _step.parameter - _step.forces);
    _step.prices = (products.slacks - _point.prices * _step.slacks) / _point.slacks;
    _step.lackCosts = -_step.velocities;
    _step.lacks = (products.lacks - _point.lacks * _step.lackCosts) / _point.lackCosts;
    _step.excessCosts = _step.velocities;
    _step.excesses = (products.excesses - _point.excesses * _step.excessCosts) / _point.excessCosts;
    _step.parameterSlack = -_step.parameter;
    _step.parameterPrice = (products.parameter - _point.parameterPrice * _step.parameterSlack) / _point.parameterSlack;
}

bool InteriorPointSolver::improveStep(Products& products, double target)
{
    constexpr double WANTED_GAIN = 0.3;
    constexpr double LEAST_GAIN = 0.02;
    const auto findTotals = [&]
    {
        const auto [primal, dual] = findLengths();
        return std::pair(std::min(primal, 1.0), std::min(dual, 1.0));
    };
    const auto [primal, dual] = findTotals();
    if (std::min(primal, dual) >= LONG_STEP) return false;
    const Point end = advance(std::min(primal + WANTED_GAIN, 1.0), std::min(dual + WANTED_GAIN, 1.0));
    Products changed = products;
    changed.forces += _isSigned * findCorrection(end.forces * end.costs, target);
    changed.slacks += _isDrag * findCorrection(end.slacks * end.prices, target);
    changed.lacks += findCorrection(end.lacks * end.lackCosts, target);
    changed.excesses += findCorrection(end.excesses * end.excessCosts, target);
    if (_parameter.isFree)
        changed.parameter +=
            findCorrection(Eigen::ArrayXd::Constant(1, end.parameterSlack * end.parameterPrice), target)[0];
    Point previous = _step;
    findStep(changed);
    const auto [changedPrimal, changedDual] = findTotals();
    if (!(changedPrimal + changedDual >= primal + dual + LEAST_GAIN))
    {
        _step = std::move(previous);
        return false;
    }
    products = std::move(changed);
    return true;
}

std::pair<double, double> InteriorPointSolver::findLengths() const
{
    double primal = std::min({findLength(_divisors, _isSigned * _step.forces), findLength(_point.slacks, _step.slacks),
                              findLength(_point.lacks, _step.lacks), findLength(_point.excesses, _step.excesses)});
    double dual =
        std::min({findLength(_point.costs + (1.0 - _isSigned), _step.costs),
                  findLength(_point.prices + (1.0 - _isDrag), _step.prices),
                  findLength(_point.lackCosts, _step.lackCosts), findLength(_point.excessCosts, _step.excessCosts)});
    if (_parameter.isFree)
    {
        primal = std::min(primal, 1.0 / std::max(1e-10, -_step.parameterSlack / _point.parameterSlack));
        dual = std::min(dual, 1.0 / std::max(1e-10, -_step.parameterPrice / _point.parameterPrice));
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
    point.parameter = _point.parameter + primal * _step.parameter;
    point.parameterSlack = _point.parameterSlack + primal * _step.parameterSlack;
    point.costs = _point.costs + dual * _step.costs;
    point.prices = _point.prices + dual * _step.prices;
    point.lackCosts = _point.lackCosts + dual * _step.lackCosts;
    point.excessCosts = _point.excessCosts + dual * _step.excessCosts;
    point.velocities = _point.velocities + dual * _step.velocities;
    point.parameterPrice = _point.parameterPrice + dual * _step.parameterPrice;
    return point;
}

} // namespace osgLego
