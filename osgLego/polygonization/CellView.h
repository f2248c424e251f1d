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

/** The view of a grid's cells, computed in double precision: the eye, intersections with the near plane, rays of
 * pixels.
 *
 * A plain value without GL. For any projection that can be inverted, in perspective or not.
 */
struct CellView
{
    /** @param cellsToEye, projection matrices as in osg::State. */
    CellView(const BrickGrid& grid, const osg::Matrixd& cellsToEye, const osg::Matrixd& projection);

    /** The origins and directions of the rays of pixels, in cells: at the lower left corner of the picture, and the
     * changes per pixel to the right and upwards. */
    struct Rays
    {
        glm::mat3 origin{0.0f};
        glm::mat3 direction{0.0f};
        /** The depth, 0 to 1, at the start of a ray: at the corner, and the changes per pixel, as above. */
        glm::vec3 depth{0.0f};
        /** The change of depth with the ray's parameter or, in perspective, with its reciprocal. */
        float depthSlope = 0.0f;
        /** The weight by which the origin is divided and the depth is multiplied: at the corner, and the changes per
         * pixel. Others than 1, 0, 0 belong to parallel rays in perspective, such as those of shadow maps in light
         * space. */
        glm::vec3 weight{1.0f, 0.0f, 0.0f};

        bool isLinear() const { return weight.y == 0.0f && weight.z == 0.0f; }

        /** The same rays in stud coordinates, whose last axis is up. @param up the up axis of the grid. */
        Rays onAxesOfStud(int up) const;
    };

    /** The rays of a picture with the given size in pixels. */
    Rays computeRays(const glm::ivec2& size) const;

    /** Whether single precision is enough to distinguish the rays of adjacent pixels. It is not if the eye is far away
     * and has a narrow field of view. */
    bool areDistinct(const Rays& rays, const glm::ivec2& size) const;
    /** Whether the weights of all pixels are positive, without rounding. */
    static bool areWeightsPositive(const Rays& rays, const glm::ivec2& size);

    /** Whether depth depends only on the ray's parameter. It does not if the near plane is oblique. */
    static bool isDepthDistance(const Rays& rays);

    /** The bounds of a box, given in cells, in the picture: left, lower, right, upper, where the picture is from -1
     * to 1. Valid only if isAllBehindNearPlane, for a box that may contain bricks. */
    glm::vec4 areaOf(const glm::dvec3& lower, const glm::dvec3& upper) const;

    /** The eye's position in cells or, if w is 0, the direction towards the eye. */
    glm::vec4 eye{0.0f};
    /** The planes of the view frustum in cells, positive inside. */
    std::array<glm::vec4, 6> planes{};
    /** Whether the transform reverses the winding of faces. */
    bool isMirrored = false;
    /** Whether the near plane may intersect bricks, so that they are seen from inside. */
    bool isCutOpen = false;
    /** Whether all bricks, including studs, are behind the near plane. */
    bool isAllBehindNearPlane = false;
    /** The bounds of the bricks in the picture: left, lower, right, upper, from -1 to 1. Valid if isAllBehindNearPlane.
     */
    glm::vec4 area{0.0f};
    /** The largest possible size of a brick in the picture, in the same units. Valid if isAllBehindNearPlane. */
    glm::vec2 largestBrick{0.0f};

private:
    void findCut(const BrickGrid& grid);
    void setArea(const BrickGrid& grid);

    osg::Matrixd _toClip;
    osg::Matrixd _toCells;
};

} // namespace osgLego
