#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/store/BrickStore.h>

#include <glm/vec2.hpp>
#include <osg/State>

namespace osgLego
{

/** Tell the program that a state has applied what the shaders of bricks want to know of the grid, the view, the lights
 * and the fog. Needs the context of the state current, as all of these.
 * @param showsInsides whether sides that are turned away from the eye are seen, too. */
void setBrickUniforms(const osg::State& state, const BrickGrid& grid, const CellView& view, bool showsInsides);

/** Tell it the rays of the pixels of a picture, and what their depth goes by. */
void setRays(const osg::State& state, const CellView::Rays& rays, const glm::ivec2& pictureSize);

/** Whether a state has switched on lighting and one light. */
bool hasOneLight(const osg::State& state);

/** Draw a point for each brick, or, where the blocks of the bricks are known, for those in ranges of them. */
void drawBrickPoints(osg::State& state, const ContextBricks& bricks, const BrickRanges::Parts& parts);

} // namespace osgLego
