#pragma once

#include <osgLego/layout/LayoutProblem.h>

namespace osgLego
{

/** The costs that a layout minimizes, in units small enough that a random cost can decide between equal layouts. */
struct LayoutCosts
{
    static constexpr int PART = 10000;
    /** The cost of half a unit of stacked seams, since each of the two parts at a seam counts one half. Small solid
     * models have few stacked seams anyway. */
    static constexpr int HALF_SEAM = 1000;
    static constexpr int HALF_SEAM_OF_SMALL_SOLID = 500;
    static constexpr int COMPONENT = 10 * PART;
    /** The cost by which layouts of solid models are compared with Effort::BEST. With the other costs, they have up to
     * a twentieth more parts, to avoid stacked seams. */
    static constexpr int HALF_SEAM_OF_BEST_SOLID = HALF_SEAM / 8;
    /** The cost of a part that is joined to a single other part. LEAF_OF_SHELL applies to hollow models whose interior
     * cells are fewer than those of their surface; in other models, such parts are harder to avoid and matter less. */
    static constexpr int LEAF_OF_SHELL = 9000;
    static constexpr int LEAF = 2000;
    static constexpr int UNMADE = 3 * PART;  //!< a part of one cell in a colour in which it was never made
    static constexpr int LARGEST_CHANCE = 8; //!< limit of the random cost of a joint

    /** HALF_SEAM_OF_SMALL_SOLID for a small model of which more than a fifth is interior, otherwise HALF_SEAM. */
    static int getHalfSeam(const LayoutProblem& problem);
    /** LEAF_OF_SHELL for a hollow model of which some, but less than half, is interior, otherwise LEAF. */
    static int getLeaf(const LayoutProblem& problem);
};

} // namespace osgLego
