#pragma once

#include "BookletArrow.h"
#include "BookletFrame.h"

#include <array>
#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

namespace osgLego
{

/** The parts of an arrow that must not touch those of others, each with the white line around it: the shaft, the head,
 * and the letter. y points upwards. Immutable. Uses no GL. */
class ArrowShape
{
public:
    /** @param numCharacters of the letter; 0 without one. */
    ArrowShape(const BookletArrow& arrow, std::size_t numCharacters);

    /** The middle of the base line of a letter above a tail. */
    static glm::dvec2 findLetter(const BookletArrow& arrow);

    bool touches(const ArrowShape& other) const;
    /** All of the arrow. */
    const BookletFrame& getFrame() const { return _frame; }
    /** The rectangle of the letter; nothing without one. */
    const std::optional<BookletFrame>& getLetter() const { return _letter; }

private:
    using Quadrangle = std::array<glm::dvec2, 4>; // convex; a triangle has a corner twice

    static bool areApart(const Quadrangle& own, const Quadrangle& other);
    static bool areApart(const BookletFrame& own, const BookletFrame& other);

    std::array<Quadrangle, 3> _pieces;
    std::size_t _numPieces = 2;
    std::optional<BookletFrame> _letter;
    BookletFrame _frame;
};

} // namespace osgLego
