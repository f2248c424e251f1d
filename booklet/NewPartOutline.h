#pragma once

#include "NewPartMask.h"

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <osg/Image>

namespace osgLego
{

/** A colour of pixels: red, green and blue (sRGB). */
using PixelColor = std::array<std::uint8_t, 3>;

/** The contrast of two colours by WCAG 2.2, 1 to 21. */
double getContrast(const PixelColor& color, const PixelColor& other);

/** Draws a line around the new parts in the picture of a step, so that they are found at once in any colour.
 *
 *     NewPartOutline(NewPartMask::create(...)).draw(*picture);
 *
 * Its colour has a contrast of at least 3 to nearly all of its surroundings, the earlier parts and the background.
 * One thread. */
class NewPartOutline
{
public:
    static constexpr double LEAST_CONTRAST = 3.0; //!< of graphics by WCAG

    /** The places that a mask needs around the new parts. */
    static constexpr int MARGIN = 6;

    explicit NewPartOutline(const NewPartMask& mask);

    /** Draw the line into the picture of the mask, 8-bit RGB. @return its colour. */
    PixelColor draw(osg::Image& picture) const;

private:
    float findShare(const std::vector<float>& shares, double x, double y) const;
    PixelColor chooseColor(const osg::Image& picture) const;

    glm::ivec2 _lowest;
    int _width;
    int _height;
    std::vector<float> _ring;    // the share of the line in each place of the mask
    std::vector<float> _outside; // likewise, of the surroundings beside the line
};

} // namespace osgLego
