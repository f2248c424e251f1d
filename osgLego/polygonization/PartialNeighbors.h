#pragma once

#include <osgLego/polygonization/BrickStates.h>
#include <osgLego/polygonization/DrawnBricks.h>
#include <osgLego/store/ContextBricks.h>

#include <osg/State>

namespace osgLego
{

/** The grid occlusion of a partly built model. If the number of parts in place has changed, a transform feedback finds
 * the neighbours in place of each brick, without an upload. The caller holds the mutex of `context`, whose context is
 * current; afterwards, the state for triangles is applied.
 * @param bricks those of the parts in place.
 * @param states for models drawn partly built with grid occlusion.
 * @return null if there is no memory, or no program. */
const GridOcclusionTextures* findPartialNeighbors(osg::State& state, ContextBricks& context, const DrawnBricks& bricks,
                                                  const BrickStates& states);

} // namespace osgLego
