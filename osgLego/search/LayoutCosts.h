#pragma once

#include <osgLego/layout/LayoutProblem.h>

namespace osgLego
{

/** The costs that a layout minimizes, in units small enough for a random choice between equal layouts. */
struct LayoutCosts
{
    static constexpr int PART = 10000;
    /** Half a unit of stacked seams: each of its two parts bears a half. In small solid models, few seams are stacked
     * anyway. */
    static constexpr int HALF_SEAM = 1000;
    static constexpr int HALF_SEAM_OF_SMALL_SOLID = 500;
    static constexpr int COMPONENT = 10 * PART;
    /** A part that hangs on a single other part, which makes that an articulation part: in models with an interior that
     * is smaller than the surface, such as shells, and in others, where such parts are harder to avoid or matter less.
     */
    static constexpr int LEAF_OF_SHELL = 9000;
    static constexpr int LEAF = 2000;
    static constexpr int UNMADE = 3 * PART;  //!< a single cell in a colour in which that part was never made
    static constexpr int LARGEST_CHANCE = 8; //!< the random cost of a joint

    /** HALF_SEAM_OF_SMALL_SOLID for a small model of which more than a fifth is interior, otherwise HALF_SEAM. */
    static int getHalfSeam(const LayoutProblem& problem);
    /** LEAF_OF_SHELL for a model of which some, but less than half, is interior, otherwise LEAF. */
    static int getLeaf(const LayoutProblem& problem);
};

} // namespace osgLego
