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

/** Draws a line around new parts in the picture of a step, so that they are found at once in any colour.
 *
 *     const std::vector<NewPartOutline> outlines{NewPartOutline(NewPartMask::create(...))};
 *     const PixelColor color = NewPartOutline::chooseColor(outlines, *picture);
 *     outlines.front().draw(*picture, color);
 *
 * One thread. */
class NewPartOutline
{
public:
    static constexpr double LEAST_CONTRAST = 3.0; //!< of graphics by WCAG

    /** The places that a mask needs around the new parts. */
    static constexpr int MARGIN = 6;

    explicit NewPartOutline(const NewPartMask& mask);

    /** A colour for some outlines. Its contrast to nearly all of their surroundings, the earlier parts and the
     * background, is at least 3 or, if no colour has that, as large as possible.
     * @param picture that of the masks, 8-bit RGB, still without outlines. */
    static PixelColor chooseColor(const std::vector<NewPartOutline>& outlines, const osg::Image& picture);
    /** Draw the line into the picture of the mask. */
    void draw(osg::Image& picture, const PixelColor& color) const;

private:
    void addSurroundings(const osg::Image& picture, std::vector<PixelColor>& colors) const;
    float findShare(const std::vector<float>& shares, double x, double y) const;

    glm::ivec2 _lowest;
    int _width;
    int _height;
    std::vector<float> _ring;    // the share of the line in each place of the mask
    std::vector<float> _outside; // likewise, of the surroundings beside the line
};

} // namespace osgLego
