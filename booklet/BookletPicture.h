#pragma once

#include "BookletArrow.h"
#include "BookletBlocks.h"
#include "BookletModel.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** A picture as it is embedded in a page. */
struct BookletPicture
{
    std::string bytes;     //!< of the file
    std::string mediaType; //!< such as "image/png"
    int width = 0;         //!< pixels
    int height = 0;        //!< pixels
    double density = 1.0;  //!< pixels per pixel of CSS (1/96 inch)
    double pitch = 1.0;    //!< pixels per stud
    std::vector<BookletArrow>
        arrows; //!< in pixels from the top left: one to each submodel, and then to each hidden part
};

/** Draws the pictures of a booklet. One thread. */
class BookletPictureSource
{
public:
    virtual ~BookletPictureSource() = default;

    /** Set what is printed together: pictures of its steps have the same scale in each chapter, and may leave out what
     * is far below the parts that they add. At first, each chapter is a section. */
    virtual void setSection(std::size_t chapter, std::span<const BookletBlock> blocks) = 0;
    /** A part alone, on a transparent background; all parts are drawn at one scale. */
    virtual BookletPicture drawKind(std::size_t kind) = 0;
    /** The base plate alone, on a transparent background, smaller than parts. The model must have one. */
    virtual BookletPicture drawBasePlate() = 0;
    /** The finished model or submodel, on a transparent background. Submodels are drawn at the scale of parts alone,
     * unless they would be very large. */
    virtual BookletPicture drawFinished(std::size_t chapter) = 0;
    /** A small picture of the finished model or submodel that shows where the parts of some blocks are, on a
     * transparent background. */
    virtual BookletPicture drawPlace(std::size_t chapter, std::span<const BookletBlock> blocks) = 0;
    /** The size of drawFinished() of a submodel, in pixels of CSS. */
    virtual glm::dvec2 measureFinished(std::size_t chapter) const = 0;
    /** The size of drawStep(), in studs. */
    virtual glm::dvec2 measureStep(std::size_t chapter, std::size_t step) const = 0;
    /** Whether drawFinished() shows enough of each part of a submodel that it can be built from this picture, or as
     * much as the picture of its only step. */
    virtual bool replacesSteps(std::size_t chapter) = 0;
    /** A chapter after a step. All pictures of a chapter in a section have the same scale and the same width. */
    virtual BookletPicture drawStep(std::size_t chapter, std::size_t step) = 0;
    /** The width of a chapter's pictures in the section, divided by the height of the tallest of them. */
    virtual double getAspect(std::size_t chapter) const = 0;
};

} // namespace osgLego
