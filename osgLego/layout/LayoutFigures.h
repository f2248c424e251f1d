#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <cstddef>

namespace osgLego
{

/** Figures that describe how good a layout is. Two parts are connected if one lies directly on the other. */
struct LayoutFigures
{
    std::size_t cells = 0;
    std::size_t parts = 0;
    std::size_t components = 0;         //!< sets of parts that are connected, directly or through others
    std::size_t componentsPossible = 0; //!< no layout of the cells has fewer; see countPossibleComponents()
    std::size_t articulationParts = 0;  //!< parts whose removal would split their component
    std::size_t floating = 0;           //!< parts in components that don't reach the lowest layer
    std::size_t joints = 0;             //!< joints between horizontal neighbours, each as long as a cell
    std::size_t stackedLength = 0;      //!< those of the joints that lie on a joint of the layer below
    /** Those of the stacked joints that no layout avoids, since they are between cells of different colours. Not
     * counted in layouts of plates, where a brick may cover three layers. */
    std::size_t stackedBorders = 0;
    std::size_t colors = 0;      //!< colours in use
    std::size_t unavailable = 0; //!< parts whose size was never made in their colour

    /** The share of joints that lie on a joint of the layer below, 0 to 1. */
    double getStackedSeams() const { return getShareOfJoints(stackedLength); }
    /** Likewise for stackedBorders. */
    double getStackedBorders() const { return getShareOfJoints(stackedBorders); }

private:
    double getShareOfJoints(std::size_t count) const
    {
        return joints == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(joints);
    }
};

/** Compute the figures of a layout in which findLayoutError() finds no error. Where a part continues in the layer
 * above, as a brick beside plates does, a joint between the same two parts counts once, and no joint of that part is
 * stacked. */
LayoutFigures computeLayoutFigures(const LayoutProblem& problem, const LaidParts& parts);

} // namespace osgLego
