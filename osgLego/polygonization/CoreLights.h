#pragma once

#include <osgLego/polygonization/LightNumbers.h>

#include <array>

#include <osg/Light>
#include <osg/Matrixd>
#include <osg/RenderInfo>
#include <osg/State>

namespace osgLego
{

/** The lights of the scene as uniforms, for contexts of the core profile, where GL keeps no lights. Does nothing in
 * other contexts.
 *
 * Used while a drawable is drawn, as long as its state stays applied.
 */
class CoreLights
{
public:
    /** Find the enabled lights, and where the stage that is being drawn positions them. Needs the context current. */
    explicit CoreLights(osg::RenderInfo& renderInfo);

    /** Set the uniforms of lights and materials in the program that a state has applied. Needs its context current. */
    void apply(const osg::State& state) const;

private:
    struct PositionedLight
    {
        const osg::Light* light = nullptr;
        osg::Matrixd toEye;
    };

    std::array<PositionedLight, LightNumbers::MAXIMUM> _lights; // by their numbers
    bool _isCore = false;
};

} // namespace osgLego
