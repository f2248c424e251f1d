#pragma once

#include "CaptureOptions.h"

#include <osgLego/LegoSettings.h>

#include <functional>

#include <osg/BoundingSphere>
#include <osg/Camera>
#include <osg/Vec3d>

namespace osgLego
{

class SceneReach;

/** Where the camera of a capture stands, and what it sees.
 *
 *     CaptureCamera place(options.view, UpAxis::Z, 16.0 / 9.0);
 *     place.moveToDistance(node->getBound());
 *     place.apply(*camera);
 */
class CaptureCamera
{
public:
    /** @param aspect the width of the picture over its height. */
    CaptureCamera(const CaptureView& view, UpAxis upAxis, double aspect);

    /** Stand the view's distance away from the middle of a sphere. */
    void moveToDistance(const osg::BoundingSphere& bound);

    /** Stand as near as all of a scene fits in.
     * @param addScene gives the visitor all that is to be seen. */
    void moveToFit(const osg::BoundingSphere& bound, const std::function<void(SceneReach&)>& addScene);

    void apply(osg::Camera& camera) const;

private:
    void moveToMiddle(double radii);

    CaptureView _view;
    double _aspect;
    osg::Vec3d _right;
    osg::Vec3d _up;
    osg::Vec3d _toEye;
    double _vertical;    // half of the angle of view, in radians
    double _radii = 0.0; // from the middle of the sphere to the eye
    osg::BoundingSphere _bound;
    osg::Vec3d _eye;
    osg::Vec3d _target;
    double _halfHeight = 0.0; // of an orthographic view, in model units
};

} // namespace osgLego
