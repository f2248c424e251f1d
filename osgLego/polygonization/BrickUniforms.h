#pragma once

#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/polygonization/DepthPass.h>
#include <osgLego/polygonization/DrawnBricks.h>
#include <osgLego/polygonization/Faces.h>

#include <glm/vec2.hpp>
#include <osg/State>

namespace osgLego
{

/** Set the uniforms of the bricks, the view, the lights and the fog in the program that a state has applied. Like all
 * functions in this file, needs the context of the state current.
 * @param faces those that are drawn. */
void setBrickUniforms(const osg::State& state, const DrawnBricks& bricks, const CellView& view, Faces faces);

/** Set the uniforms of shaders/polygonization/partial_bricks.glsl. */
void setPartUniforms(const osg::State& state, const DrawnBricks& bricks);

/** Set the uniforms of a picture's rays and their depth. */
void setRays(const osg::State& state, const CellView::Rays& rays, const glm::ivec2& pictureSize);

/** Set the uniforms for splats that are drawn right into a depth buffer. */
void setDepthConversion(const osg::State& state, const DepthConversion& conversion);

/** Whether a state has enabled lighting and exactly one light. */
bool hasOneLight(const osg::State& state);

/** Draw a point for each brick or, if the blocks of the bricks are known, for each brick in the given ranges. */
void drawBrickPoints(osg::State& state, const DrawnBricks& bricks, const BrickRanges::Parts& parts);
/** Draw a point for each brick, in their order. */
void drawAllBrickPoints(osg::State& state, const DrawnBricks& bricks);

} // namespace osgLego
