#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace osgLego
{

/** A rectangle in the plane of a picture, in pitches: x to the right, y upwards. */
struct BookletFrame
{
    glm::dvec2 lowest{0.0};
    glm::dvec2 highest{0.0};

    glm::dvec2 getSize() const { return highest - lowest; }

    /** The smallest rectangle around this one and another. */
    BookletFrame unite(const BookletFrame& other) const
    {
        return {glm::min(lowest, other.lowest), glm::max(highest, other.highest)};
    }

    /** This rectangle with a margin on each side. */
    BookletFrame addMargin(double margin) const { return {lowest - margin, highest + margin}; }
};

} // namespace osgLego
