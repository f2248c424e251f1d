#pragma once

#include "BookletArrow.h"
#include "BookletFrame.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** The place to which an arrow points. */
struct ArrowTarget
{
    glm::dvec2 tip{0.0};
    std::size_t numCharacters = 0; //!< of the letter above the arrow's tail; 0 for none
};

/** Places the arrows of a picture: each comes from above, and neither shafts, heads nor letters touch those of other
 * arrows. Where other places are free, arrows and letters cover none of the parts that the picture shows, and arrows
 * stay above the model. Arrows to places that are very near each other are thinner.
 *
 *     const ArrowPlacement placement(targets, 0.45, frameOfModel, framesOfNewParts);
 *     frame = frame.unite(placement.getFrame());
 *
 * Immutable. Uses no GL. */
class ArrowPlacement
{
public:
    /** Lengths are pitches.
     * @param targets whose tips differ; if some differ by less than about a third of `width`, or hundreds are crowded,
     * arrows may touch each other.
     * @param width of the arrows' shafts, if they fit.
     * @param area the model in place; arrows beside it need wider pictures.
     * @param shown what arrows should not cover. */
    ArrowPlacement(std::span<const ArrowTarget> targets, double width, const BookletFrame& area,
                   std::span<const BookletFrame> shown);

    /** One for each target, in their order, all equally wide. */
    const std::vector<BookletArrow>& getArrows() const { return _arrows; }
    /** What the arrows and their letters cover; nothing without arrows. */
    const std::optional<BookletFrame>& getFrame() const { return _frame; }

private:
    std::vector<BookletArrow> _arrows;
    std::optional<BookletFrame> _frame;
};

} // namespace osgLego
