#pragma once

#include <osgLego/store/GridOcclusionTextures.h>

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

    /** @param occlusion null if it is not known: nothing is occluded. */
    explicit GridOcclusionView(const GridOcclusionTextures* occlusion) : _occlusion(occlusion) {}

    /** Bind the textures, and set the uniforms of the program that a state has applied. Needs its context current. */
    void apply(osg::State& state) const;

private:
    osg::ref_ptr<const GridOcclusionTextures> _occlusion;
};

} // namespace osgLego
