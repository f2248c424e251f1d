#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <osg/Camera>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/Light>
#include <osg/Node>
#include <osg/Vec4>
#include <osg/ref_ptr>
#include <osgViewer/Viewer>

namespace osgLego
{

/** Draws pictures of a scene with bricks: its camera, its light and the frames until the bricks exist.
 *
 *     PictureRenderer renderer(*context);
 *     renderer.setScene(*lego);
 *     renderer.getCamera().setViewMatrixAsLookAt(...);
 *     const osg::ref_ptr<osg::Image> picture = renderer.draw({640, 480}, background);
 *
 * Pictures are drawn into frame buffer objects, so that their size, their samples and their formats do not depend on
 * the context. Animations are drawn as they are at the simulation time 0. When the object is destroyed, it deletes the
 * GL objects of its scene; the context can be used again. One thread.
 */
class PictureRenderer
{
public:
    static constexpr int SAMPLES = 4;

    /** The first thing that a context lacks to draw bricks, in one sentence; empty if it can. Call it before drawing:
     * otherwise OSG would report every shader that the context can't compile. */
    static std::string findMissing(osg::GraphicsContext& context);

    /** @param context realized, and not current.
     * @param samples per pixel. */
    explicit PictureRenderer(osg::GraphicsContext& context, int samples = SAMPLES);
    ~PictureRenderer();
    PictureRenderer(const PictureRenderer&) = delete;
    PictureRenderer& operator=(const PictureRenderer&) = delete;

    /** Show a scene instead of the one before. */
    void setScene(osg::Node& scene);
    /** The camera, which has no place yet. */
    osg::Camera& getCamera() { return *_camera; }
    /** Set the brightness of the light from above the left of the camera: 1, unless this is called. */
    void setBrightness(float brightness);

    /** Draw the scene.
     * @param size in pixels.
     * @return 8-bit RGB, bottom row first. */
    osg::ref_ptr<osg::Image> draw(const glm::ivec2& size, const osg::Vec4& background);
    /** Draw the scene over a transparent background.
     * @return 8-bit RGBA with straight alpha, bottom row first. */
    osg::ref_ptr<osg::Image> drawTransparent(const glm::ivec2& size);
    /** Draw the last picture again, for nothing but its time.
     * @return milliseconds. */
    double timeFrame();

private:
    void addLight();

    osg::ref_ptr<osg::GraphicsContext> _context;
    osgViewer::Viewer _viewer;
    osg::ref_ptr<osg::Camera> _camera;
    osg::ref_ptr<osg::Node> _scene;
    osg::ref_ptr<osg::Light> _light;
    unsigned int _samples;
};

} // namespace osgLego
