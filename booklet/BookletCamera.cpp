#include "BookletCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <osg/Math>

namespace osgLego
{

namespace
{

osg::Vec3d toOsg(const glm::dvec3& vector)
{
    return {vector.x, vector.y, vector.z};
}

} // namespace

BookletCamera::BookletCamera(const BrickGrid& grid, const BookletView& view) : _grid(grid)
{
    const bool isYUp = grid.upAxis == UpAxis::Y;
    const osg::Vec3d up = isYUp ? osg::Vec3d(0, 1, 0) : osg::Vec3d(0, 0, 1);
    const osg::Vec3d front = isYUp ? osg::Vec3d(0, 0, 1) : osg::Vec3d(0, -1, 0);
    const osg::Vec3d right(1, 0, 0);
    const double azimuth = osg::DegreesToRadians(view.front.azimuth + 90.0 * view.turns);
    // Upside down, the model turns about its front: the camera sees its underside, and its up axis points downwards.
    const double sign = view.isUpsideDown ? -1.0 : 1.0;
    const double elevation = osg::DegreesToRadians(sign * view.front.elevation);
    const osg::Vec3d ahead = front * std::cos(azimuth) + right * std::sin(azimuth);
    _toEye = ahead * std::cos(elevation) + up * std::sin(elevation);
    _up = (up * std::cos(elevation) - ahead * std::sin(elevation)) * sign;
    _right = _up ^ _toEye;
    const osg::Quat turn(azimuth - osg::DegreesToRadians(BuildingStep::AZIMUTH), up);
    _lightTurn = view.isUpsideDown ? turn * osg::Quat(osg::PI, ahead) : turn;
}

BookletFrame BookletCamera::findFrame(std::span<const Part> parts, const BrickGrid& grid) const
{
    const int up = grid.getUpIndex();
    const glm::dvec3 origin = (grid.origin - _grid.origin) / _grid.cellSize;
    const glm::dvec3 scale = grid.cellSize / _grid.cellSize;
    BookletFrame frame{glm::dvec2(std::numeric_limits<double>::max()),
                       glm::dvec2(std::numeric_limits<double>::lowest())};
    for (const Part& part : parts)
    {
        glm::dvec3 size(part.getSize());
        size[up] += grid.getStudHeight();
        for (int corner = 0; corner < 8; ++corner)
        {
            const glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
            const glm::dvec2 point = project(origin + scale * (glm::dvec3(part.getCell()) + share * size));
            frame.lowest = glm::min(frame.lowest, point);
            frame.highest = glm::max(frame.highest, point);
        }
    }
    return frame;
}

glm::dvec2 BookletCamera::project(const glm::dvec3& cell) const
{
    const osg::Vec3d place = toOsg(cell * _grid.cellSize / _grid.getPitch());
    return {place * _right, place * _up};
}

glm::dvec3 BookletCamera::getStart(const glm::dvec2& place) const
{
    const glm::dvec3 size = glm::dvec3(_grid.dimensions) * _grid.cellSize / _grid.getPitch();
    // The grid's corners are nearer to its origin than this, studs included.
    const double distance = size.x + size.y + size.z + 1.0;
    const osg::Vec3d start = _right * place.x + _up * place.y + _toEye * distance;
    return {start.x(), start.y(), start.z()};
}

osg::Quat BookletCamera::getLightTurn() const
{
    return _lightTurn;
}

void BookletCamera::apply(osg::Camera& camera, const BookletFrame& frame) const
{
    const double pitch = _grid.getPitch();
    const glm::dvec2 middle = 0.5 * (frame.lowest + frame.highest) * pitch;
    const glm::dvec2 half = 0.5 * frame.getSize() * pitch;
    const osg::Vec3d centre = toOsg(_grid.origin + 0.5 * glm::dvec3(_grid.dimensions) * _grid.cellSize);
    const osg::Vec3d fromOrigin = centre - toOsg(_grid.origin);
    const osg::Vec3d target = toOsg(_grid.origin) + _right * middle.x + _up * middle.y + _toEye * (fromOrigin * _toEye);
    // Far enough from any brick: a picture without perspective has the same content from any distance.
    const double radius = fromOrigin.length() + 4.0 * pitch;
    camera.setViewMatrixAsLookAt(target + _toEye * (2.0 * radius), target, _up);
    camera.setProjectionMatrixAsOrtho(-half.x, half.x, -half.y, half.y, radius * 0.5, radius * 4.0);
}

} // namespace osgLego
