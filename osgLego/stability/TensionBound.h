#pragma once

#include <osgLego/stability/EquilibriumProgram.h>
#include <osgLego/stability/TwoLevelSolver.h>

#include <functional>
#include <optional>
#include <vector>

namespace osgLego
{

/** Finds forces that keep very many parts in equilibrium, whose tension is not the least, but a bound of it.
 *
 * The forces are vertical and those of springs at the contact points, stiff where they push and soft where they pull.
 * Of a joint, only the sum of the forces counts, since other forces at its points with the same sum may pull less.
 * Joints that need to pull much are made softer, so that others help. Each step takes time in proportion to the number
 * of contacts, while a step of the linear program takes that of a factorization.
 *
 * Usage:
 *
 *     const std::optional<std::vector<double>> pulls = TensionBound(program, isCancelled).find(0.7);
 *
 * One thread. */
class TensionBound
{
public:
    /** @param program with a body for each part; it must outlive this object. @param isCancelled may be empty. */
    TensionBound(const EquilibriumProgram& program, std::function<bool()> isCancelled);

    /** @param capacity the greatest pull at a contact point, in newtons.
     * @return for each joint of the program, the least pull with which its points have the force that was found, in
     * newtons; nothing if no such forces were found, or if it was cancelled. */
    std::optional<std::vector<double>> find(double capacity);

private:
    /** A contact whose points act vertically. */
    struct Bearing
    {
        std::size_t joint = 0;
        std::int32_t lower = EquilibriumProgram::NO_BODY;
        std::int32_t upper = EquilibriumProgram::NO_BODY;
        Eigen::Vector2d lowerArm = Eigen::Vector2d::Zero(); //!< from the centre of a body to the origin of `points`
        Eigen::Vector2d upperArm = Eigen::Vector2d::Zero();
        std::vector<Eigen::Vector2d> points;
        std::vector<bool> pushes; //!< for each point
        bool canPull = true;      //!< not a table
        double softness = 1.0;    //!< the stiffness of points that pull
        double pull = 0.0;        //!< newtons at a point, in the last forces
    };

    void addBearing(std::size_t index);
    TwoLevelSolver::Matrix createMovements() const;
    TwoLevelSolver::Matrix createMatrix() const;
    static Eigen::Vector3d toRow(const Eigen::Vector2d& arm, const Eigen::Vector2d& point);
    double getStiffness(const Bearing& bearing, std::size_t point) const;
    double getApproach(const Bearing& bearing, std::size_t point) const;
    void findPulls();
    double getMostPull() const;
    bool isLifted() const;
    bool solve(double tolerance);
    void adapt();
    bool isBalanced() const;
    std::vector<double> listPulls() const;

    const EquilibriumProgram& _program;
    std::function<bool()> _isCancelled;
    std::vector<Bearing> _bearings;
    Eigen::VectorXd _loads; // of each body: a force and two torques
    TwoLevelSolver::Matrix _matrix;
    TwoLevelSolver _solver;
    Eigen::VectorXd _sinking; // of each body: how far it sinks, and how it inclines
};

} // namespace osgLego
