#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <osgUtil/RenderStage>

namespace osgLego
{

/** A rectangle of pixels in a picture. */
struct PictureArea
{
    glm::ivec2 begin{0}; //!< the lower left pixel
    glm::ivec2 end{0};   //!< beyond the upper right pixel

    bool isEmpty() const { return end.x <= begin.x || end.y <= begin.y; }
    glm::ivec2 getSize() const { return end - begin; }

    /** The texels of a smaller picture, with one texel for `pixels` * `pixels` pixels, that this area touches. */
    PictureArea dividedBy(int pixels) const { return {begin / pixels, (end + pixels - 1) / pixels}; }

    bool operator==(const PictureArea&) const = default;
};

/** Find the part of a picture in which the drawables of a stage may be seen: the rectangle around their bounds, with a
 * small margin.
 * @param size of the picture, in pixels.
 * @return the whole picture if a drawable has no bounds, reaches behind the eye, or has points or lines, which may be
 * wide. */
PictureArea findArea(osgUtil::RenderStage& stage, const glm::ivec2& size);

} // namespace osgLego
