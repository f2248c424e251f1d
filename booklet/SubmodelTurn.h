#pragma once

#include <osgLego/BrickModel.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace osgLego
{

/** How a submodel lies, compared with an equal one. */
struct SubmodelTurn
{
    static constexpr int NUM_TURNS = 4;

    int turns = 0;                    //!< quarter turns, 0 to 3, counter-clockwise from above
    std::vector<std::uint32_t> equal; //!< for each of its parts, that of the other submodel

    /** Compare submodels of grids with the same up axis.
     * @param kinds of the parts of each, by numbers.
     * @return the fewest turns; nothing if they are not equal. */
    static std::optional<SubmodelTurn> find(const BrickModel& submodel, std::span<const std::size_t> kinds,
                                            const BrickModel& other, std::span<const std::size_t> otherKinds);
};

} // namespace osgLego
