#include <osgLego/polygonization/CellView.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <osg/BoundingBox>
#include <osg/Vec4d>

namespace osgLego
{

namespace
{

// Smaller changes of weights per pixel are due to rounding.
constexpr double ROUNDED_WEIGHT = 1e-12;

glm::dvec3 firstThree(const osg::Vec4d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

/** A row of the matrix in GLSL's convention: the linear function for one clip coordinate. */
glm::dvec4 rowOf(const osg::Matrixd& matrix, int row)
{
    return {matrix(0, row), matrix(1, row), matrix(2, row), matrix(3, row)};
}

/** The size of a brick with its stud, in cells. */
glm::dvec3 sizeOfBrick(const BrickGrid& grid)
{
    glm::dvec3 size(1.0);
    size[grid.getUpIndex()] += grid.getStudHeight();
    return size;
}

/** The size of the box that contains all bricks with their studs, in cells. */
glm::dvec3 sizeOfAll(const BrickGrid& grid)
{
    return glm::dvec3(grid.dimensions) + sizeOfBrick(grid) - 1.0;
}

/** The minimum of a linear function in a box with one corner at the origin. */
double leastOf(const glm::dvec4& function, const glm::dvec3& size)
{
    double least = function.w;
    for (int axis = 0; axis < 3; ++axis)
        least += std::min(function[axis] * size[axis], 0.0);
    return least;
}

} // namespace

CellView::CellView(const BrickGrid& grid, const osg::Matrixd& cellsToEye, const osg::Matrixd& projection) :
    _toClip(cellsToEye * projection), _toCells(osg::Matrixd::inverse(_toClip))
{
    // The eye is the point whose clip coordinates x, y and w are 0; without perspective, this is a direction away from
    // the eye.
    const osg::Vec4d center = osg::Vec4d(0.0, 0.0, 1.0, 0.0) * _toCells;
    const bool isPlace = std::abs(center.w()) > 1e-12 * glm::length(firstThree(center));
    eye =
        isPlace ? glm::vec4(firstThree(center) / center.w(), 1.0) : glm::vec4(-glm::normalize(firstThree(center)), 0.0);
    const glm::dvec3 x(cellsToEye(0, 0), cellsToEye(0, 1), cellsToEye(0, 2));
    const glm::dvec3 y(cellsToEye(1, 0), cellsToEye(1, 1), cellsToEye(1, 2));
    const glm::dvec3 z(cellsToEye(2, 0), cellsToEye(2, 1), cellsToEye(2, 2));
    const bool isModelMirrored = glm::dot(glm::cross(x, y), z) < 0.0;
    const bool isPictureMirrored = projection(0, 0) * projection(1, 1) < projection(0, 1) * projection(1, 0);
    isMirrored = isModelMirrored != isPictureMirrored;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const glm::dvec4 row = rowOf(_toClip, static_cast<int>(axis));
        planes[2 * axis] = glm::vec4(rowOf(_toClip, 3) + row);
        planes[2 * axis + 1] = glm::vec4(rowOf(_toClip, 3) - row);
    }
    findCut(grid);
    if (isAllBehindNearPlane) setArea(grid);
}

void CellView::findCut(const BrickGrid& grid)
{
    const glm::dvec3 all = sizeOfAll(grid);
    isAllBehindNearPlane =
        leastOf(rowOf(_toClip, 2) + rowOf(_toClip, 3), all) > 0.0 && leastOf(rowOf(_toClip, 3), all) > 0.0;
    if (isAllBehindNearPlane) return;
    // The bounding box of the visible part of the near plane.
    osg::BoundingBoxd cut;
    for (int corner = 0; corner < 4; ++corner)
        cut.expandBy(osg::Vec3d(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, -1.0) * _toCells);
    isCutOpen = cut.intersects(osg::BoundingBoxd(0.0, 0.0, 0.0, all.x, all.y, all.z));
}

void CellView::setArea(const BrickGrid& grid)
{
    const glm::dvec3 brick = sizeOfBrick(grid);
    const glm::dvec3 all = sizeOfAll(grid);
    area = glm::clamp(areaOf(glm::dvec3(0.0), sizeOfAll(grid)), -1.0f, 1.0f);
    // The quotients of two corners differ by no more than this while one of them is in the picture.
    const glm::dvec4 w = rowOf(_toClip, 3);
    for (int axis = 0; axis < 2; ++axis)
    {
        const glm::dvec4 row = rowOf(_toClip, axis);
        const double most = glm::dot(glm::abs(glm::dvec3(row)) + glm::abs(glm::dvec3(w)), brick);
        largestBrick[axis] = static_cast<float>(most / leastOf(w, all));
    }
}

glm::vec4 CellView::areaOf(const glm::dvec3& lower, const glm::dvec3& upper) const
{
    glm::dvec2 least(1e30);
    glm::dvec2 most(-1e30);
    for (int corner = 0; corner < 8; ++corner)
    {
        const osg::Vec3d seen =
            osg::Vec3d(corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y, corner & 4 ? upper.z : lower.z) *
            _toClip;
        least = glm::min(least, glm::dvec2(seen.x(), seen.y()));
        most = glm::max(most, glm::dvec2(seen.x(), seen.y()));
    }
    return {least, most};
}

bool CellView::areDistinct(const Rays& rays, const glm::ivec2& size) const
{
    constexpr float ROUNDING = 6e-8f;
    constexpr float WANTED = 0.02f; // of a pixel
    const float range = glm::length(rays.origin[0]);
    // The width of a pixel at the distance of the bricks; the direction of a ray has a length of about 1.
    const glm::vec3 middle = rays.origin * glm::vec3(1.0f, 0.5f * glm::vec2(size));
    const float width =
        eye.w == 0.0f ? glm::length(rays.origin[1] - rays.weight.y * middle) : range * glm::length(rays.direction[1]);
    return range * ROUNDING < WANTED * width;
}

bool CellView::areWeightsPositive(const Rays& rays, const glm::ivec2& size)
{
    constexpr float LEAST = 1e-3f;
    const glm::vec2 changes = glm::vec2(rays.weight.y, rays.weight.z) * glm::vec2(size);
    return rays.weight.x + std::min(changes.x, 0.0f) + std::min(changes.y, 0.0f) > LEAST;
}

bool CellView::isDepthDistance(const Rays& rays)
{
    return std::max(std::abs(rays.depth.y), std::abs(rays.depth.z)) <= 1e-9f * std::abs(rays.depth.x);
}

CellView::Rays CellView::Rays::onAxesOfStud(int up) const
{
    Rays turned = *this;
    for (int column = 0; column < 3; ++column)
        for (int axis = 0; axis < 3; ++axis)
        {
            turned.origin[column][axis] = origin[column][(up + 1 + axis) % 3];
            turned.direction[column][axis] = direction[column][(up + 1 + axis) % 3];
        }
    return turned;
}

CellView::Rays CellView::computeRays(const glm::ivec2& size) const
{
    Rays rays;
    // The corner, and the steps per pixel to the right and up, in clip coordinates on the near plane.
    const std::array<osg::Vec4d, 3> steps{osg::Vec4d(-1.0, -1.0, -1.0, 1.0), osg::Vec4d(2.0 / size.x, 0.0, 0.0, 0.0),
                                          osg::Vec4d(0.0, 2.0 / size.y, 0.0, 0.0)};
    std::array<osg::Vec4d, 3> places;
    std::transform(steps.begin(), steps.end(), places.begin(),
                   [this](const osg::Vec4d& step) { return step * _toCells; });
    if (eye.w == 0.0f)
    {
        rays.direction = glm::mat3(-glm::vec3(eye), glm::vec3(0.0f), glm::vec3(0.0f));
        const double middle = places[0].w() + 0.5 * (size.x * places[1].w() + size.y * places[2].w());
        for (int column = 0; column < 3; ++column)
        {
            const osg::Vec4d& place = places[static_cast<std::size_t>(column)];
            const double weight = place.w() / middle;
            rays.origin[column] = glm::vec3(firstThree(place) / middle);
            rays.weight[column] = std::abs(weight) > ROUNDED_WEIGHT ? static_cast<float>(weight) : 0.0f;
        }
        // Rays start on the near plane.
        const double deeper = glm::dot(glm::dvec3(rowOf(_toClip, 2)), -glm::dvec3(eye));
        rays.depthSlope = static_cast<float>(0.5 * deeper * middle);
        return rays;
    }
    const osg::Vec4d center = osg::Vec4d(0.0, 0.0, 1.0, 0.0) * _toCells;
    const glm::dvec3 origin = firstThree(center) / center.w();
    rays.origin = glm::mat3(glm::vec3(origin), glm::vec3(0.0f), glm::vec3(0.0f));
    const double length = glm::length(firstThree(places[0]) - places[0].w() * origin);
    const double scale = (places[0].w() < 0.0 ? -1.0 : 1.0) / length;
    for (int column = 0; column < 3; ++column)
    {
        const osg::Vec4d& place = places[static_cast<std::size_t>(column)];
        rays.direction[column] = glm::vec3(scale * (firstThree(place) - place.w() * origin));
        rays.depth[column] = static_cast<float>(-0.5 * place.w() / center.w());
    }
    rays.depthSlope = static_cast<float>(0.5 / (center.w() * scale));
    return rays;
}

} // namespace osgLego
