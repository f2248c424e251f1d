#pragma once

#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/polygonization/CoreLights.h>
#include <osgLego/polygonization/DistantOcclusionView.h>
#include <osgLego/polygonization/GridOcclusionView.h>
#include <osgLego/polygonization/ShadowMaps.h>

#include <optional>

#include <osg/State>

namespace osgLego
{

/** The light of the scene where bricks are drawn, and how much of it other bricks and other nodes hide. */
struct BrickLight
{
    CoreLights lights;
    ShadowMaps shadows;
    std::optional<GridOcclusionView> near;       //!< nothing if the programs use no grid occlusion
    std::optional<DistantOcclusionView> distant; //!< nothing if the programs use no distant occlusion
    int occluder = 0;                            //!< the number of the node in a geometry buffer, 1 to 255; 0: none

    /** Set textures and uniforms of the program that a state has applied. Needs its context current. */
    void apply(osg::State& state) const
    {
        lights.apply(state);
        if (!shadows.isEmpty()) shadows.apply(state);
        if (near) near->apply(state);
        if (distant) distant->apply(state);
        static const UniformName OCCLUDER("occluder");
        if (occluder > 0) ProgramUniforms(state).set(OCCLUDER, occluder);
    }
};

} // namespace osgLego
