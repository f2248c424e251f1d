#pragma once

#include "BenchScene.h"

#include <common/BrickRayCaster.h>
#include <common/JsonValue.h>
#include <osgLego/AmbientOcclusionScene.h>

#include <functional>

namespace osgLego
{

/** A scene under an AmbientOcclusionScene, drawn into pictures of single-precision floats. Throws std::runtime_error.
 * One thread. */
class OcclusionView
{
public:
    /** @param occlusion of the bricks. @param size the size of pictures, in pixels. */
    OcclusionView(const BenchScene& scene, BrickOcclusion occlusion, const glm::ivec2& size);

    /** @return single-precision RGBA, bottom row first. */
    osg::ref_ptr<osg::Image> draw(const AmbientOcclusionSettings& settings);
    /** The times of the passes of the last picture, in milliseconds. */
    AmbientOcclusionTimes getTimes() const { return _occlusion->getTimes(_viewer.getContextID()); }

    /** Compare with rays cast from the points shown by pixels.
     * @param numRays per pixel.
     * @param stride compare one of `stride` * `stride` pixels.
     * @return pixels: the number of pixels compared; rootMeanSquare and mean: errors of visibility (a positive mean is
     * too bright); constant: the root mean square error of the best uniformly grey picture; bentMean and bentMost (95 %
     * of the pixels): angles between bent normals in degrees; irradiance: the root mean square error of irradiance
     * times visibility, divided by its mean. */
    JsonValue compare(AmbientOcclusionSettings settings, int numRays, int stride);

    /** The picture of visibility that rays give, like draw() with AmbientOcclusionOutput::OCCLUSION. */
    osg::ref_ptr<osg::Image> drawByRays(const AmbientOcclusionSettings& settings, int numRays);

private:
    struct Ray
    {
        glm::dvec3 origin; // on the near plane
        glm::dvec3 direction;
    };

    /** The results of rays and the picture for a pixel. */
    using Compared = std::function<void(const glm::ivec2& pixel, const BrickRayCaster::Occlusion& rays)>;

    void castRays(const AmbientOcclusionSettings& settings, int numRays, int stride, const Compared& compared);
    Ray getRay(const glm::ivec2& pixel) const;
    glm::dvec3 readDirection(const osg::Image& image, const glm::ivec2& pixel) const;

    glm::ivec2 _size;
    FrameViewer _viewer;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<AmbientOcclusionScene> _occlusion = new AmbientOcclusionScene;
    osg::ref_ptr<osg::Camera> _camera = new osg::Camera;
    osg::ref_ptr<osg::Image> _image = new osg::Image;
};

} // namespace osgLego
