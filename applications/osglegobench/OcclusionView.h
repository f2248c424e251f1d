#pragma once

#include "BenchScene.h"

#include <osgLego/AmbientOcclusionScene.h>

#include <nlohmann/json.hpp>

namespace osgLego
{

/** A scene under an AmbientOcclusionScene, drawn into pictures of single-precision floats. Throws std::runtime_error.
 * One thread. */
class OcclusionView
{
public:
    /** @param size of pictures, in pixels. */
    OcclusionView(const BenchScene& scene, const glm::ivec2& size);

    /** @return RGBA of floats, the first row at the bottom. */
    osg::ref_ptr<osg::Image> draw(const AmbientOcclusionSettings& settings);
    /** Milliseconds of the passes of the last picture. */
    AmbientOcclusionTimes getTimes() const { return _occlusion->getTimes(_viewer.getContextID()); }

    /** Compare with rays cast from the points that pixels show.
     * @param numRays per pixel.
     * @param stride compare one of `stride` * `stride` pixels.
     * @return pixels, how many were compared; rootMeanSquare and mean error (above 0 is too bright) of visibility;
     * constant, the root mean square error of the best picture of one grey; bentMean and bentMost (95 % of the pixels),
     * degrees between bent normals; irradiance, the root mean square error of irradiance times visibility over its
     * mean. */
    nlohmann::ordered_json compare(AmbientOcclusionSettings settings, int numRays, int stride);

private:
    struct Ray
    {
        glm::dvec3 origin; // on the near plane
        glm::dvec3 direction;
    };

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
