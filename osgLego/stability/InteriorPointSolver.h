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
 * The cost of a force moves a force by no more than `forceCost` / (its inertia) in a step, and pressures between
 * neighbours and the free forces in their studs may have to move by newtons. */
struct EquilibriumInertia
{
    double freeForces = 1e-9;
    double pressures = 1e-8; //!< and drags
    double velocities = 1e-6;
};

/** The tilt of the base, as the tangent of its angle, of which a linear program finds the greatest. */
struct EquilibriumTilt
{
    Eigen::VectorXd sideLoad;  //!< the forces that are needed for a tangent of 1 in addition to the load
    double most = 1.0;         //!< the upper bound of the tangent
    double capacityRate = 0.0; //!< by which the limit of drags grows with the tangent, in newtons
};

/** The goal of a linear program: to minimize penalty * (sum of all |residuals|) + tensionCost * tension - tilt +
 * forceCost * (sum of all forces). */
struct EquilibriumGoal
{
    double penalty = 1.0;
    /** The upper bound of the tension, which is the limit of drags, in newtons. */
    double capacity = 1.0;
    /** Whether the tension is minimized; otherwise it is `capacity`. */
    bool minimizesTension = false;
    double tensionCost = 1.0; //!< of a newton of tension, if it is minimized
    /** Whether to end early, without converging, once the dual variables show that something is missing. */
    bool endsIfMissing = false;
    EquilibriumInertia inertia = {};
    /** If set, the tilt is maximized instead; otherwise there is none. */
    std::optional<EquilibriumTilt> tilt = {};
    double forceCost = 1e-6;
    double gapTolerance = 1e-7;   //!< of the goal, relative above 1
    double forceTolerance = 1e-5; //!< of the dual equations
};

/** Forces that bring parts as close to equilibrium as possible. */
struct Equilibrium
{
    Eigen::ArrayXd forces;      //!< newtons
    Eigen::ArrayXd residuals;   //!< for each row, the force that is missing, in newtons, or torque
    Eigen::VectorXd velocities; //!< for each row, the rate at which the goal would grow with its load: how parts fall
    Eigen::ArrayXd prices;      //!< for each drag, the rate at which the goal would improve if its limit were raised
    double tension = 0.0;       //!< the upper limit of drags, in newtons
    double tilt = 0.0;          //!< the tangent of the angle of the base
    int numIterations = 0;
    bool hasConverged = false;
    /** Whether the solver ended early since something is missing: see EquilibriumGoal::endsIfMissing. */
    bool isMissingCertain = false;
    /** Whether forces that have not converged are in equilibrium nevertheless, without residuals. */
    bool isBalanced = false;
};

/** Solves the linear program of an equilibrium by Mehrotra's predictor-corrector method.
 *
 * RowEquations gives the steps. The tension, or the tilt, is a dense column, which is eliminated after them.
 *
 * One thread at a time. */
class InteriorPointSolver
{
public:
    /** @param program must outlive the solver.
     * @param isCancelled ends the constructor and solve() early by returning true; may be empty. */
    explicit InteriorPointSolver(const EquilibriumProgram& program, const std::function<bool()>& isCancelled = {});

    /** If the forces do not converge, those found last are brought into equilibrium, if possible.
     * @return nothing if it was cancelled, or if the solver was before. */
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
        double parameter = 0.0;
        double parameterSlack = 1.0; //!< up to its bound
        double parameterPrice = 0.0;
    };

    /** The variable that all rows and all drags may share: the tension or the tilt. */
    struct Parameter
    {
        bool isFree = false; //!< whether there is one
        double cost = 0.0;
        double most = 1.0;
        double limit = 0.0;     //!< of drags, for a parameter of 0
        double limitRate = 0.0; //!< by which the limit grows with it
        Eigen::VectorXd load;   //!< the forces needed for each unit of it
    };

    /** Products of variables and their dual slacks that a step aims at, less the present ones. */
    struct Products
    {
        Eigen::ArrayXd forces, slacks, lacks, excesses;
        double parameter = 0.0;
    };

    void chooseParameter();
    void start();
    void startForces(double tension);
    void findErrors();
    double computeGap(const Point& point) const;
    double computeGoal() const;
    double findForceTolerance() const;
    bool isMissingCertain() const;
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
    void easeVelocities(double previousError);
    bool balance(Equilibrium& result);

    const EquilibriumProgram& _program;
    RowEquations _rows;
    Eigen::ArrayXd _isDrag;   //!< 1 or 0
    Eigen::ArrayXd _isSigned; //!< 1 or 0
    double _numProducts = 0.0;

    EquilibriumGoal _goal;
    double _velocityInertia = 0.0; //!< at most that of the goal
    Parameter _parameter;
    Point _point;
    Point _step;
    Eigen::VectorXd _rowErrors;   //!< missing in the equations of the rows
    Eigen::VectorXd _forceErrors; //!< missing in the dual equations of the forces
    double _parameterError = 0.0; //!< missing in that of the parameter
    Eigen::ArrayXd _weights;      //!< of the forces in the normal equations
    Eigen::ArrayXd _rowWeights, _divisors;
    Eigen::ArrayXd _slackWeights; //!< prices / slacks
    Eigen::VectorXd _parameterColumn;
    Eigen::VectorXd _parameterSolution;
};

} // namespace osgLego
