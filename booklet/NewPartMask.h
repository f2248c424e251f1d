#pragma once

#include "BookletCamera.h"

#include <osgLego/BrickModel.h>

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Where the new parts of a step are visible in its picture: found by rays, since a second picture takes longer.
 *
 * A place is a square of PIXELS x PIXELS pixels of the picture. A plain value; uses no GL. */
struct NewPartMask
{
    static constexpr int PIXELS = 2; //!< along each side of a place

    glm::ivec2 lowest{0};      //!< the lowest place on the left; places outside the mask have no new parts
    glm::ivec2 size{0};        //!< in places
    std::vector<float> shares; //!< of new parts in each place, 0 to 1, in rows from the bottom

    /** @param placed the parts in place, as indices into those of the model.
     * @param numNew the last of them that are new, at least one.
     * @param picture the size of the picture, in pixels; it shows `frame`.
     * @param margin the places around the new parts that belong to the mask, if they belong to the picture. */
    static NewPartMask create(const BrickModel& model, std::span<const std::uint32_t> placed, std::size_t numNew,
                              const BookletCamera& camera, const BookletFrame& frame, const glm::ivec2& picture,
                              int margin);
};

} // namespace osgLego
