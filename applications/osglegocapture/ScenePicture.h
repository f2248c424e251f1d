#pragma once

#include "CaptureOptions.h"
#include "CaptureScene.h"

#include <common/PictureRenderer.h>

#include <glm/vec2.hpp>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** The picture of a captured scene: places the camera by the options, and draws the scene.
 *
 *     ScenePicture picture(options, scene, *context);
 *     const osg::ref_ptr<osg::Image> image = picture.draw();
 *
 * Throws CaptureError. One thread.
 */
class ScenePicture
{
public:
    /** The arguments must outlive this object. @param context realized, and not current. */
    ScenePicture(const CaptureOptions& options, const CaptureScene& scene, osg::GraphicsContext& context);

    /** Draw the scene when its bricks exist, which may take long.
     * @return the picture, bottom row first: 8-bit RGB or, with a transparent background, RGBA with straight alpha. */
    osg::ref_ptr<osg::Image> draw();
    /** The time of a frame without legolization, in milliseconds, if the options have statistics; otherwise 0. */
    double getDrawingTime() const { return _drawingTime; }

    /** The size of a picture with as many pixels as that of the options, in the shape of the scene: at most 16:9 or
     * 9:16. If the view has a distance, which the scene need not fit, the size of the options. */
    static glm::ivec2 fitSize(const CaptureOptions& options, const CaptureScene& scene);

    /** The approximate memory that draw() needs for the pixels of the picture, mostly in GL buffers, in bytes. */
    static double estimateMemory(const CaptureOptions& options, const CaptureScene& scene);

private:
    void checkLegolized() const;

    const CaptureOptions& _options;
    const CaptureScene& _scene;
    osg::ref_ptr<osg::GraphicsContext> _context;
    PictureRenderer _renderer;
    double _drawingTime = 0.0;
};

} // namespace osgLego
