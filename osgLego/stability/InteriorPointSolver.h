#pragma once

#include <osgLego/stability/EquilibriumProgram.h>
#include <osgLego/stability/RowEquations.h>

#include <functional>
#include <optional>
#include <utility>

#include <Eigen/Core>

namespace osgLego
{

/** Proximal terms, which keep the equations well-conditioned: they slow down the steps of forces and of velocities, but
 * vanish together with the steps.
 *
 * The cost of a force moves a force by no more than FORCE_COST / (its inertia) in a step, and pressures between
 * neighbours and the free forces in their studs may have to move by newtons. */
struct EquilibriumInertia
{
    double freeForces = 1e-9;
    double pressures = 1e-8; //!< and drags
    double velocities = 1e-6;
};

/** The goal of a linear program: to minimize penalty * (sum of all |residuals|) + tension + FORCE_COST * (sum of all
 * forces). */
struct EquilibriumGoal
{
    static constexpr double FORCE_COST = 1e-6;

    double penalty = 1.0;
    /** The upper bound of the tension, which is the limit of drags, in newtons. */
    double capacity = 1.0;
    /** Whether the tension is minimized; otherwise it is `capacity`. */
    bool minimizesTension = false;
    EquilibriumInertia inertia = {};
};

/** Forces that bring parts as close to equilibrium as possible. */
struct Equilibrium
{
    Eigen::ArrayXd forces;    //!< newtons
    Eigen::ArrayXd residuals; //!< for each row, the force that is missing, in newtons, or torque
    Eigen::ArrayXd prices;    //!< for each drag, the rate at which the goal would improve if its limit were raised
    double tension = 0.0;     //!< the upper limit of drags, in newtons
    int numIterations = 0;
    bool hasConverged = false;
};

/** Solves the linear program of an equilibrium by Mehrotra's predictor-corrector method.
 *
 * RowEquations gives the steps. The tension is a dense column, which is eliminated after them.
 *
 * One thread at a time. */
class InteriorPointSolver
{
public:
    /** @param program must outlive the solver.
     * @param isCancelled ends the constructor and solve() early by returning true; may be empty. */
    explicit InteriorPointSolver(const EquilibriumProgram& program, const std::function<bool()>& isCancelled = {});

    /** @return nothing if it was cancelled, or if the solver was before. */
    std::optional<Equilibrium> solve(const EquilibriumGoal& goal);

private:
    /** A point near the central path, or a step from one to the next. */
    struct Point
    {
        Eigen::ArrayXd forces, costs;         //!< and their dual slacks
        Eigen::ArrayXd slacks, prices;        //!< of drags, up to the tension; 1 and 0 for other forces
        Eigen::ArrayXd lacks, lackCosts;      //!< positive residuals, and their dual slacks
        Eigen::ArrayXd excesses, excessCosts; //!< negative residuals
        Eigen::ArrayXd velocities;            //!< the dual variables of the rows
        double tension = 0.0;
        double tensionSlack = 1.0; //!< up to the capacity
        double tensionPrice = 0.0;
    };

    /** Products of variables and their dual slacks that a step aims at, less the present ones. */
    struct Products
    {
        Eigen::ArrayXd forces, slacks, lacks, excesses;
        double tension = 0.0;
    };

    void start();
    void startForces();
    void findErrors();
    double computeGap(const Point& point) const;
    bool hasConverged() const;
    void factorize();
    Products findProducts(double target) const;
    void findStep(const Products& products);
    /** Change the step so that products which would end far from the target, and block longer steps, end near it
     * (Gondzio's centrality corrections). @return whether that has lengthened the step. */
    bool improveStep(Products& products, double target);
    /** The largest shares of the step that keep all variables and all dual slacks positive. */
    std::pair<double, double> findLengths() const;
    Point advance(double primal, double dual) const;

    const EquilibriumProgram& _program;
    RowEquations _rows;
    Eigen::ArrayXd _isDrag;   //!< 1 or 0
    Eigen::ArrayXd _isSigned; //!< 1 or 0
    double _numProducts = 0.0;

    EquilibriumGoal _goal;
    Point _point;
    Point _step;
    Eigen::VectorXd _rowErrors;   //!< missing in the equations of the rows
    Eigen::VectorXd _forceErrors; //!< missing in the dual equations of the forces
    double _tensionError = 0.0;   //!< missing in that of the tension
    Eigen::ArrayXd _weights;      //!< of the forces in the normal equations
    Eigen::ArrayXd _rowWeights, _divisors;
    Eigen::ArrayXd _slackWeights; //!< prices / slacks
    Eigen::VectorXd _tensionColumn;
    Eigen::VectorXd _tensionSolution;
};

} // namespace osgLego
