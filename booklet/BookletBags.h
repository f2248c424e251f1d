#pragma once

#include "BookletBlocks.h"

#include <cstddef>
#include <span>
#include <vector>

namespace osgLego
{

/** A section of a booklet whose parts are sorted out together, as those of a numbered bag of a boxed set. */
struct BookletBag
{
    static constexpr std::size_t FEWEST_OF_MODEL = 200; //!< parts of a model with bags
    static constexpr std::size_t LEAST_PARTS = 100;     //!< of a bag, if possible
    static constexpr std::size_t USUAL_PARTS = 150;
    static constexpr std::size_t MOST_PARTS = 200; //!< likewise

    std::size_t firstBlock = 0;
    std::size_t endBlock = 0;       //!< behind the last of them
    std::vector<BookletItem> items; //!< all parts, in the order of kinds

    std::size_t countParts() const { return sumQuantities(items); }
};

/** Divide what is built into bags of 100 to 200 parts. Bags that begin with a step of the main model, or with a
 * submodel of such a step, are preferred to those that begin within a submodel, unless these are nearer to those limits
 * by several parts.
 *
 * Uses no GL. May be called from any thread. @return at least two, or none for a model of few parts. */
std::vector<BookletBag> createBags(std::span<const BookletBlock> blocks);

} // namespace osgLego
