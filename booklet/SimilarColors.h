#pragma once

#include "BookletModel.h"

#include <cstddef>
#include <set>
#include <vector>

namespace osgLego
{

/** The colours of a model that are easily confused with each other, such as dark greys and browns. Immutable. Uses no
 * GL. */
class SimilarColors
{
public:
    /** The difference CIEDE2000 below which readers need the names of two colours. */
    static constexpr double LEAST_DIFFERENCE = 20.0;

    explicit SimilarColors(const BookletModel& model);

    /** Choose a kind of parts for each colour that is similar to another one of the model.
     * @param kinds indices into BookletModel::getKinds().
     * @return some of `kinds`, in their order: the first in each such colour. */
    std::vector<std::size_t> chooseKinds(const std::set<std::size_t>& kinds) const;

private:
    std::vector<std::size_t> _first; // for each kind, the first one in its colour
    std::vector<bool> _isSimilar;    // for each kind
};

} // namespace osgLego
