#pragma once

#include <array>
#include <osgLego/BrickGrid.h>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <osg/Matrixd>

namespace osgLego
{

/** How the cells of a grid are seen, reckoned in double precision: the eye, what may be cut open, the rays of pixels.
 *
 * A plain value without GL. For any projection that can be inverted, in perspective or not.
 */
struct CellView
{
    /** @param cellsToEye, projection as osg::State has them. */
    CellView(const BrickGrid& grid, const osg::Matrixd& cellsToEye, const osg::Matrixd& projection);

    /** Where the rays of pixels start, and which way they go, in cells: in the lower left corner of the picture, and
     * what to add for each pixel to the right and upwards. */
    struct Rays
    {
        glm::mat3 origin{0.0f};
        glm::mat3 direction{0.0f};
        /** Depth from 0 to 1 of a place on a ray: of the pixel likewise, */
        glm::vec3 depth{0.0f};
        /** and to add for how far on it is or, in perspective, for the reciprocal of that. */
        float depthSlope = 0.0f;

        /** The same on the axes of a stud, the last of which is up, by the axis of the grid that is. */
        Rays onAxesOfStud(int up) const;
    };

    /** The rays of a picture of a size in pixels. */
    Rays computeRays(const glm::ivec2& size) const;

    /** Whether floats hold the places that rays start from so well that each pixel's own is told from the next: not so
     * where the eye is far away and sees little. */
    bool areDistinct(const Rays& rays) const;

    /** Whether the depth of a place goes by how far on its ray it is alone: not so where the near plane is oblique. */
    static bool isDepthDistance(const Rays& rays);

    /** What part of the picture a box in cells lies in: left, lower, right, upper, from -1 to 1, and beyond where it
     * reaches beyond; if isAllBehindNearPlane, and for a box in which bricks may lie. */
    glm::vec4 areaOf(const glm::dvec3& lower, const glm::dvec3& upper) const;

    /** The eye's place in cells; where the last number is 0, the direction towards it. */
    glm::vec4 eye{0.0f};
    /** The sides of the room that is seen, above 0 inside of it, in cells. */
    std::array<glm::vec4, 6> planes{};
    /** Whether what winds counter-clockwise seen from outside does not so in the picture. */
    bool isMirrored = false;
    /** Whether the near plane may lie within bricks, so that they are seen from inside. */
    bool isCutOpen = false;
    /** Whether all bricks, studs included, lie behind the near plane. */
    bool isAllBehindNearPlane = false;
    /** What part of the picture they lie in: left, lower, right, upper, from -1 to 1; if isAllBehindNearPlane. */
    glm::vec4 area{0.0f};
    /** As large as a brick's picture can be, from -1 to 1; likewise. */
    glm::vec2 largestBrick{0.0f};

private:
    void findCut(const BrickGrid& grid);
    void setArea(const BrickGrid& grid);

    osg::Matrixd _toClip;
    osg::Matrixd _toCells;
};

} // namespace osgLego
