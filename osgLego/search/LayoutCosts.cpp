#include <osgLego/search/LayoutCosts.h>

#include <cstddef>

namespace osgLego
{

int LayoutCosts::getHalfSeam(const LayoutProblem& problem)
{
    constexpr std::size_t SMALL = 1000;
    const bool isSolid = problem.countInterior() > problem.cells.size() / 5;
    return isSolid && problem.cells.size() < SMALL ? HALF_SEAM_OF_SMALL_SOLID : HALF_SEAM;
}

int LayoutCosts::getLeaf(const LayoutProblem& problem)
{
    const std::size_t numInside = problem.countInterior();
    const bool isThin = numInside > 0 && numInside < problem.cells.size() / 2;
    return problem.isHollow && isThin ? LEAF_OF_SHELL : LEAF;
}

} // namespace osgLego
