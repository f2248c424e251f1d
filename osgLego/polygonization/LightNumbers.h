#pragma once

#include <array>

#include <osg/State>

namespace osgLego
{

/** The numbers of the lights that a state has enabled, in the order in which shaders/light/lighting.glsl adds them up.
 */
struct LightNumbers
{
    static constexpr int MAXIMUM = 8;

    explicit LightNumbers(const osg::State& state);

    std::array<int, MAXIMUM> numbers{};
    int count = 0; //!< negative: lighting is off
};

} // namespace osgLego
