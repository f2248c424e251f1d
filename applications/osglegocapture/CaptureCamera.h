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

/** The position and projection of a capture's camera.
 *
 *     CaptureCamera place(options.view, UpAxis::Z, 16.0 / 9.0);
 *     place.moveToDistance(node->getBound());
 *     place.apply(*camera);
 */
class CaptureCamera
{
public:
    /** @param aspect the width of the picture, divided by its height. */
    CaptureCamera(const CaptureView& view, UpAxis upAxis, double aspect);

    /** Move the camera to the view's distance from the centre of a sphere. */
    void moveToDistance(const osg::BoundingSphere& bound);

    /** Move the camera as near as possible with the whole scene in view.
     * @param addScene passes everything that must be in view to the visitor. */
    void moveToFit(const osg::BoundingSphere& bound, const std::function<void(SceneReach&)>& addScene);

    /** The width of the scene in the view, divided by its height, after moveToFit(); the aspect if the scene is empty.
     */
    double getSceneAspect() const { return _sceneAspect; }

    void apply(osg::Camera& camera) const;

private:
    void moveToMiddle(double radii);

    CaptureView _view;
    double _aspect;
    double _sceneAspect;
    osg::Vec3d _right;
    osg::Vec3d _up;
    osg::Vec3d _toEye;
    double _vertical;    // half of the vertical field of view, in radians
    double _radii = 0.0; // distance from the centre of the sphere to the eye, in radii
    osg::BoundingSphere _bound;
    osg::Vec3d _eye;
    osg::Vec3d _target;
    double _halfHeight = 0.0; // of an orthographic view, in model units
};

} // namespace osgLego
