#pragma once

#include <glm/vec2.hpp>
#include <osg/RenderInfo>
#include <osg/State>

namespace osgLego
{

/** Whether drawing changes only depths and stencil values, as in a camera for a shadow map: the camera draws into a
 * frame buffer object to which a program has attached no colours, or draw buffers and color mask let none pass. Needs
 * the context of the state current. */
bool isDepthPass(osg::RenderInfo& renderInfo);

/** The conversion of depths, 0 to 1 between the near and the far plane, to those of the current depth buffer. */
struct DepthConversion
{
    /** Read it from the current context. */
    explicit DepthConversion(const osg::State& state);

    glm::vec2 range{0.0f, 1.0f}; //!< of the depths
    /** glPolygonOffset, in depths: for each unit of the slope, and constant. */
    glm::vec2 offset{0.0f};
};

} // namespace osgLego
