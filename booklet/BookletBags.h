#pragma once

#include "BookletModel.h"

#include <cstddef>
#include <vector>

namespace osgLego
{

/** Some steps of the main model whose parts are sorted out together, as those of a numbered bag of a boxed set. */
struct BookletBag
{
    static constexpr std::size_t LEAST_PARTS = 200; //!< of a model with bags
    static constexpr std::size_t USUAL_PARTS = 150; //!< of a bag; it has 100 to 200, as far as steps permit

    std::size_t firstStep = 0;
    std::size_t endStep = 0;        //!< behind the last of them
    std::vector<BookletItem> items; //!< all parts, those of submodels included, in the order of kinds

    std::size_t countParts() const;
};

/** Divide the steps of the main model into bags of nearly equal numbers of parts.
 *
 * Uses no GL. May be called from any thread. @return at least two, or none for a model of few parts. */
std::vector<BookletBag> createBags(const BookletModel& model);

} // namespace osgLego
