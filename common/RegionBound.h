#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace osgLego
{

/** The fewest parts that can cover some cells of one layer. */
struct RegionBound
{
    std::size_t parts = 0;
    bool isOptimum = true; //!< false: it took too long to find the optimum, which is at least `parts`

    bool operator==(const RegionBound&) const = default;
};

/** Compute the fewest parts that can cover some cells of one layer, by linear programming and, if its solution is
 * fractional, by branch and cut (COIN-OR's CLP and CBC): each part that fits is a variable, and each cell is covered
 * once.
 *
 * May be called from any thread, and from several at once.
 *
 * @param cells in one layer; not empty.
 * @param colors the sizes in which each colour exists; bricks only. A cell that none of them can cover counts as a
 * part.
 * @param seconds the time after which the bound of the search so far is returned.
 * @param isCancelled ends the search early, with some bound, by returning true; called from the calling thread. May be
 * empty. */
RegionBound boundRegion(const std::vector<LayoutCell>& cells, const std::vector<LayoutColor>& colors, double seconds,
                        const std::function<bool()>& isCancelled);

} // namespace osgLego
