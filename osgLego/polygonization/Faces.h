#pragma once

#include <osgLego/polygonization/CellView.h>

#include <osg/State>

namespace osgLego
{

/** The faces of bricks that are drawn. The values are those of `drawnFaces` in
 * shaders/polygonization/polygonization.geom. */
enum class Faces
{
    FRONT = 1, //!< turned towards the eye
    BACK = 2,  //!< turned away from it
    ALL = 3
};

/** The view of bricks with a state.
 * @param cellsToEye the transform from cells to eye coordinates. */
CellView createView(const osg::State& state, const BrickGrid& grid, const osg::Matrixd& cellsToEye);

/** The faces that may be visible with a state: those that it doesn't cull and, if it shows only the nearest surface,
 * without clipping and blending, only the outer sides of bricks, which are closed. */
Faces findVisibleFaces(const osg::State& state, const CellView& view);

} // namespace osgLego
