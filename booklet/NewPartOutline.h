#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osg/Image>

namespace osgLego
{

/** A colour of pixels: red, green and blue (sRGB). */
using PixelColor = std::array<std::uint8_t, 3>;

/** The contrast of two colours by WCAG 2.2, 1 to 21. */
double getContrast(const PixelColor& color, const PixelColor& other);

/** Draws a line around the new parts in the picture of a step, so that they are found at once in any colour.
 *
 *     NewPartOutline(*dark, *light).draw(*picture);
 *
 * Its colour has a contrast of at least 3 to nearly all of its surroundings, the earlier parts and the background.
 * One thread. */
class NewPartOutline
{
public:
    static constexpr double LEAST_CONTRAST = 3.0; //!< of graphics by WCAG

    /** @param dark the same picture with new parts in black, of any size with the same aspect: 8-bit RGB, as all
     * pictures here.
     * @param light the same with new parts in white. */
    NewPartOutline(const osg::Image& dark, const osg::Image& light);

    /** Draw the line into a picture. @return its colour. */
    PixelColor draw(osg::Image& picture) const;

private:
    float findShare(const std::vector<float>& shares, double x, double y) const;
    PixelColor chooseColor(const osg::Image& picture) const;

    int _width;
    int _height;
    std::vector<float> _ring;    // the share of the line in each pixel of the smaller pictures
    std::vector<float> _outside; // likewise, of the surroundings beside the line
};

} // namespace osgLego
