#pragma once

#include <osgLego/store/GridOcclusionTextures.h>

#include <glm/vec2.hpp>
#include <osg/State>
#include <osg/ref_ptr>

namespace osgLego
{

/** The occlusion of bricks by the cells around them, for shaders/polygonization/grid_occlusion.glsl. */
class GridOcclusionView
{
public:
    // After those of shadow maps.
    static constexpr unsigned int NEIGHBORS_UNIT = 12;
    static constexpr unsigned int TABLE_UNIT = 13;
    static constexpr unsigned int STUDS_UNIT = 14;

    /** @param occlusion null if it is not known: nothing is occluded.
     * @param pixelWidth in cells, at the depth z in eye coordinates: |x + y * z|. */
    GridOcclusionView(const GridOcclusionTextures* occlusion, const glm::vec2& pixelWidth) :
        _occlusion(occlusion), _pixelWidth(pixelWidth)
    {
    }

    /** Bind the textures, and set the uniforms of the program that a state has applied. Needs its context current. */
    void apply(osg::State& state) const;

private:
    osg::ref_ptr<const GridOcclusionTextures> _occlusion;
    glm::vec2 _pixelWidth;
};

} // namespace osgLego
