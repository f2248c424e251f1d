#pragma once

#include "BookletModel.h"

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** A picture as it is embedded in a page. */
struct BookletPicture
{
    std::string bytes;     //!< of the file
    std::string mediaType; //!< such as "image/webp"
    int width = 0;         //!< pixels
    int height = 0;        //!< pixels
    double density = 1.0;  //!< pixels per pixel of CSS (1/96 inch)
    /** Where submodels are attached, in pixels from the top left: an arrow ends at each. */
    std::vector<glm::dvec2> arrows;
};

/** Draws the pictures of a booklet. One thread. */
class BookletPictureSource
{
public:
    virtual ~BookletPictureSource() = default;

    /** A part alone, on a transparent background; all parts are drawn at one scale. */
    virtual BookletPicture drawKind(std::size_t kind) = 0;
    /** The finished model or submodel, on a transparent background. */
    virtual BookletPicture drawFinished(std::size_t chapter) = 0;
    /** A chapter after a step. All pictures of a chapter have the same scale and the same width. */
    virtual BookletPicture drawStep(std::size_t chapter, std::size_t step) = 0;
    /** The width of a chapter's pictures, divided by the height of the tallest of them. */
    virtual double getAspect(std::size_t chapter) const = 0;
};

} // namespace osgLego
