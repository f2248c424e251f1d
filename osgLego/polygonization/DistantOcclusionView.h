#pragma once

#include <osgLego/store/DistantOcclusionTexture.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <osg/Matrixd>
#include <osg/State>
#include <osg/ref_ptr>

namespace osgLego
{

/** Distant occlusion as an eye sees it, for shaders/polygonization/distant_occlusion.glsl. */
class DistantOcclusionView
{
public:
    // Different from those of relief and splats.
    static constexpr unsigned int MEAN_UNIT = 2;
    static constexpr unsigned int BEND_UNIT = 3;

    /** @param isExact whether the occlusion is that of the bricks that are drawn, and not of other ones.
     * @param modelView from model units to eye coordinates.
     * @param width of the picture, in pixels.
     * @param share the factor of the occlusion, 0 to 1. */
    DistantOcclusionView(DistantOcclusionTexture& occlusion, bool isExact, const osg::Matrixd& modelView,
                         const osg::Matrixd& projection, double width, double share);

    /** Bind the textures, and set the uniforms of the program that a state has applied. Needs its context current. */
    void apply(osg::State& state) const;

private:
    osg::ref_ptr<DistantOcclusionTexture> _occlusion;
    glm::mat4 _eyeToVoxels;
    glm::vec2 _pixelWidth;
    float _share;
    bool _includesNear;
};

} // namespace osgLego
