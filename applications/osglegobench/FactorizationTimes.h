#pragma once

#include <osgLego/stability/EquilibriumProgram.h>

#include <vector>

namespace osgLego
{

/** Milliseconds that factorizations of the same normal matrix take, in each run. */
struct FactorizationTimes
{
    std::vector<double> blocks;     //!< BlockCholesky, as the interior-point solver uses it
    std::vector<double> simplicial; //!< Eigen's SimplicialLLT
};

/** Factorize the normal matrix of a program whose forces have equal weights, after the order of elimination has been
 * chosen. Throws std::runtime_error if the factorizations solve different equations. */
FactorizationTimes measureFactorizations(const EquilibriumProgram& program, unsigned int numRuns);

} // namespace osgLego
