#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

/** The squares of one size that cover a small area of a picture with few pixels beside it: an alternative to the tiles
 * of a PictureTiles, of which a small area may intersect many and fill few.
 *
 * A plain value without GL.
 *
 * @code
 * if (FittedTiles::isSmall(area, size)) draw(FittedTiles::fit(area, size));
 * @endcode
 */
struct FittedTiles
{
    static constexpr int LARGEST_AREA = 128 * 128; //!< above which PictureTiles fit better, in pixels

    glm::ivec2 first{0}; //!< the lower left pixel of all
    glm::ivec2 count{0}; //!< squares across and up
    int side = 1;        //!< of a square, in pixels

    /** Whether an area is small enough. @param area as in fit(). */
    static bool isSmall(const glm::vec4& area, const glm::ivec2& size);

    /** Cover an area; without squares if it is outside the picture.
     * @param area left, lower, right, upper, where the picture is from -1 to 1. @param size of the picture, in pixels.
     */
    static FittedTiles fit(const glm::vec4& area, const glm::ivec2& size);
};

} // namespace osgLego
