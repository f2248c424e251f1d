#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace osgLego
{

/** The fewest bricks that can cover one layer by itself. No layout has fewer in that layer. */
struct LayerBound
{
    int z = 0;
    std::size_t parts = 0;
    bool isOptimum = true; //!< false: it took too long to find the optimum, which is at least `parts`

    bool operator==(const LayerBound&) const = default;
};

/** How bounds are computed. */
struct BoundOptions
{
    double seconds = 60.0; //!< the time for each connected region of a layer
    /** Called regularly, from any thread; the computation ends early if it returns true. May be empty. */
    std::function<bool()> isCancelled;
};

/** Compute the fewest bricks that can cover each of some layers by itself; their sum is a lower bound for any layout.
 * Regions of a layer that no part can connect are solved separately, on threads of oneTBB, and equal regions once.
 *
 * @param problem of bricks, not of plates.
 * @param layers z of the layers, in any order; empty for all layers that have cells.
 * @return a bound for each of the layers, in the same order; empty if it was cancelled. */
std::vector<LayerBound> boundLayers(const LayoutProblem& problem, std::vector<int> layers, const BoundOptions& options);

} // namespace osgLego
