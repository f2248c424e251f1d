#pragma once

#include <osgLego/polygonization/DistantOcclusionView.h>
#include <osgLego/polygonization/ShadowMaps.h>

#include <optional>

#include <osg/State>

namespace osgLego
{

/** The light that other bricks and other nodes hide from the bricks that are drawn. */
struct HiddenLight
{
    ShadowMaps shadows;
    std::optional<DistantOcclusionView> distant; //!< nothing if the programs use no distant occlusion

    /** Set textures and uniforms of the program that a state has applied. Needs its context current. */
    void apply(osg::State& state) const
    {
        if (!shadows.isEmpty()) shadows.apply(state);
        if (distant) distant->apply(state);
    }
};

} // namespace osgLego
