#include "CaptureCamera.h"

#include "SceneReach.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <osg/Math>

namespace osgLego
{

namespace
{

constexpr double FIELD_OF_VIEW = 30.0; // degrees, along the shorter side of the picture
constexpr double FILLED = 0.96;        // the part of the picture filled by a scene that just fits in

double halfViewOf(double aspect)
{
    const double half = osg::DegreesToRadians(0.5 * FIELD_OF_VIEW);
    return aspect >= 1.0 ? half : std::atan(std::tan(half) / aspect);
}

} // namespace

CaptureCamera::CaptureCamera(const CaptureView& view, UpAxis upAxis, double aspect) :
    _view(view), _aspect(aspect), _sceneAspect(aspect), _vertical(halfViewOf(aspect))
{
    const bool isYUp = upAxis == UpAxis::Y;
    const osg::Vec3d up = isYUp ? osg::Vec3d(0, 1, 0) : osg::Vec3d(0, 0, 1);
    const osg::Vec3d front = isYUp ? osg::Vec3d(0, 0, 1) : osg::Vec3d(0, -1, 0);
    const osg::Vec3d right(1, 0, 0);
    const double azimuth = osg::DegreesToRadians(view.azimuth);
    const double elevation = osg::DegreesToRadians(view.elevation);
    const osg::Vec3d ahead = front * std::cos(azimuth) + right * std::sin(azimuth);
    _toEye = ahead * std::cos(elevation) + up * std::sin(elevation);
    _up = up * std::cos(elevation) - ahead * std::sin(elevation);
    _right = _up ^ _toEye;
}

void CaptureCamera::moveToDistance(const osg::BoundingSphere& bound)
{
    _bound = bound;
    moveToMiddle(_view.distance);
}

void CaptureCamera::moveToMiddle(double radii)
{
    _radii = radii;
    _target = _bound.center();
    _eye = osg::Vec3d(_bound.center()) + _toEye * (radii * _bound.radius());
    // The scale at the centre is the same as in a perspective view.
    _halfHeight = std::tan(_vertical) * radii * _bound.radius();
}

void CaptureCamera::moveToFit(const osg::BoundingSphere& bound, const std::function<void(SceneReach&)>& addScene)
{
    _bound = bound;
    // As near as the sphere fits in; this remains the distance of an orthographic view, or if the scene is empty.
    moveToMiddle(1.0 / (FILLED * std::sin(osg::DegreesToRadians(0.5 * FIELD_OF_VIEW))));

    // A point at x to the right and z towards the eye is in the view of an eye at X, Z if |x - X| <= slope * (Z - z),
    // that is, if x + slope * z and -x + slope * z are at most slope * Z + X and slope * Z - X. The maxima of both over
    // all points determine how near the eye may be. In an orthographic view, slope is 0.
    const double upSlope = _view.orthographic ? 0.0 : FILLED * std::tan(_vertical);
    const double rightSlope = upSlope * _aspect;
    SceneReach visitor(
        {_right + _toEye * rightSlope, -_right + _toEye * rightSlope, _up + _toEye * upSlope, -_up + _toEye * upSlope});
    addScene(visitor);
    if (!visitor.isValid() || !(bound.radius() > 0.0f)) return;

    const std::vector<double>& reach = visitor.getReach();
    const double halfWidth = 0.5 * (reach[0] + reach[1]);
    const double halfHeight = 0.5 * (reach[2] + reach[3]);
    if (halfHeight > 0.0) _sceneAspect = halfWidth / halfHeight;
    const double back = _view.orthographic ? _toEye * _eye : std::max(halfWidth / rightSlope, halfHeight / upSlope);
    _eye = _right * (0.5 * (reach[0] - reach[1])) + _up * (0.5 * (reach[2] - reach[3])) + _toEye * back;
    _target = _eye - _toEye * bound.radius();
    _radii = (_eye - osg::Vec3d(bound.center())).length() / bound.radius();
    _halfHeight = std::max(halfHeight, halfWidth / _aspect) / FILLED;
}

void CaptureCamera::apply(osg::Camera& camera) const
{
    const double near = (_view.near > 0.0 ? _view.near : std::max(0.01, 0.5 * (_radii - 2.0))) * _bound.radius();
    const double far = (_radii + 4.0) * _bound.radius();
    if (_view.orthographic)
        camera.setProjectionMatrixAsOrtho(-_halfHeight * _aspect, _halfHeight * _aspect, -_halfHeight, _halfHeight,
                                          near, far);
    else
        camera.setProjectionMatrixAsPerspective(osg::RadiansToDegrees(2.0 * _vertical), _aspect, near, far);
    camera.setViewMatrixAsLookAt(_eye, _target, _up);
}

} // namespace osgLego
