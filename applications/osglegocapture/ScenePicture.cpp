#include "ScenePicture.h"

#include "CaptureCamera.h"
#include "ExitCode.h"
#include "SceneReach.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <osg/BoundingSphere>
#include <osg/Camera>
#include <osg/Vec4>

namespace osgLego
{

namespace
{

const osg::Vec4 BACKGROUND(0.66f, 0.72f, 0.79f, 1.0f);
// Growth of resident memory per pixel, measured with llvmpipe: for the frame buffer object and the picture, and for the
// buffers of an AmbientOcclusionScene.
constexpr double BYTES_PER_PIXEL = 50.0;
constexpr double OCCLUSION_BYTES_PER_PIXEL = 160.0;

/** Throws CaptureError if no camera sees all of the scene. */
CaptureCamera placeCamera(const CaptureOptions& options, const CaptureScene& scene, double aspect)
{
    const osg::BoundingSphere bound = scene.getBound();
    if (!(bound.radius() < 0.0f) && !(std::isfinite(bound.radius()) && std::isfinite(bound.center().length())))
        throw CaptureError(EXIT_BAD_INPUT,
                           "the mesh has coordinates that are not finite or so large that no camera sees all of it; "
                           "expected at most 1e+18, or bricks, which leave such triangles out");
    CaptureCamera camera(options.view, scene.getUpAxis(), aspect);
    if (options.view.distance > 0.0)
        camera.moveToDistance(bound);
    else
        camera.moveToFit(bound, [&scene](SceneReach& reach) { scene.addTo(reach); });
    return camera;
}

} // namespace

ScenePicture::ScenePicture(const CaptureOptions& options, const CaptureScene& scene, osg::GraphicsContext& context) :
    _options(options), _scene(scene), _context(&context), _renderer(context, options.samples)
{
    if (options.view.near > 0.0)
        _renderer.getCamera().setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    // The full look also has environment light.
    const LegoNode* lego = scene.getLegoNode();
    const bool isFull = lego && lego->getSettings().view.look == Look::FULL;
    _renderer.setBrightness(isFull ? 1.0f : 0.7f);
    _renderer.setScene(scene.getNode());
    placeCamera(options, scene, static_cast<double>(options.width) / options.height).apply(_renderer.getCamera());
}

osg::ref_ptr<osg::Image> ScenePicture::draw()
{
    if (_scene.getLegoNode())
        if (const std::string missing = PictureRenderer::findMissing(*_context); !missing.empty())
            throw CaptureError(EXIT_NO_GL, missing);
    const glm::ivec2 size(_options.width, _options.height);
    osg::ref_ptr<osg::Image> image =
        _options.transparent ? _renderer.drawTransparent(size) : _renderer.draw(size, BACKGROUND);
    checkLegolized();
    // A frame without legolization.
    if (!_options.statistics.empty()) _drawingTime = _renderer.timeFrame();
    return image;
}

glm::ivec2 ScenePicture::fitSize(const CaptureOptions& options, const CaptureScene& scene)
{
    if (options.view.distance > 0.0) return {options.width, options.height};
    constexpr double WIDEST = 16.0 / 9.0;
    constexpr int NUM_STEPS = 4;
    double aspect = 1.0;
    // The shape of a scene depends on the distance, which depends on the shape of the picture.
    for (int step = 0; step < NUM_STEPS; ++step)
        aspect = std::clamp(placeCamera(options, scene, aspect).getSceneAspect(), 1.0 / WIDEST, WIDEST);
    const double height = std::sqrt(static_cast<double>(options.width) * options.height / aspect);
    return {std::lround(height * aspect), std::lround(height)};
}

double ScenePicture::estimateMemory(const CaptureOptions& options, const CaptureScene& scene)
{
    const AmbientOcclusionScene* occlusion = scene.getOcclusionScene();
    const bool hasOcclusion = occlusion && occlusion->getEnabled();
    return (BYTES_PER_PIXEL + (hasOcclusion ? OCCLUSION_BYTES_PER_PIXEL : 0.0)) * options.width * options.height;
}

void ScenePicture::checkLegolized() const
{
    const LegoNode* lego = _scene.getLegoNode();
    if (!lego) return;
    const osg::State& state = *_context->getState();
    if (const std::string failure = lego->getFailure(state.getContextID()); !failure.empty())
        throw CaptureError(LegoNode::isSupported(state) ? EXIT_BAD_INPUT : EXIT_NO_GL, failure);
    if (!lego->isLegolized(state.getContextID()))
        throw CaptureError(EXIT_BAD_INPUT, "the scene does not draw its bricks; expected a level of detail, or a view, "
                                           "in which they are seen");
}

} // namespace osgLego
