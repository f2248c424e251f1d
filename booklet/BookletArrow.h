#pragma once

#include <array>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace osgLego
{

/** An arrow in a picture: a shaft, a head at its tip, and perhaps a letter above its tail. Its lengths have the unit of
 * the picture's plane, such as pixels. */
struct BookletArrow
{
    // Lengths in widths of the shaft.
    static constexpr double HEAD_WIDTH = 3.0;
    static constexpr double HEAD_LENGTH = 2.0;
    static constexpr double LETTER_SIZE = 3.0; //!< of the font
    static constexpr double HALO = 0.2;        //!< the white line around it

    glm::dvec2 tail{0.0};
    glm::dvec2 tip{0.0};
    double width = 0.0;     //!< of its shaft
    glm::dvec2 letter{0.0}; //!< the middle of the base line of its letter

    glm::dvec2 getDirection() const { return glm::normalize(tip - tail); }
    /** The end of the shaft, where the head begins. */
    glm::dvec2 getNeck() const { return tip - getDirection() * (HEAD_LENGTH * width); }
    /** The corners, from one side of the tail over the tip to its other side. */
    std::array<glm::dvec2, 7> getCorners() const
    {
        const glm::dvec2 along = getDirection();
        const glm::dvec2 across = glm::dvec2(-along.y, along.x) * (0.5 * width);
        const glm::dvec2 neck = getNeck();
        return {tail + across, neck + across, neck + HEAD_WIDTH * across, tip, neck - HEAD_WIDTH * across,
                neck - across, tail - across};
    }
};

} // namespace osgLego
