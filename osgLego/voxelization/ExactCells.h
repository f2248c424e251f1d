#pragma once

#include <osgLego/passes/PassWorkspace.h>

#include <functional>

#include <osg/Program>
#include <osg/State>
#include <osg/ref_ptr>

namespace osgLego
{

/** Get the program that draws a point for each cell that a fine triangle overlaps.
 * @param fragmentShader the shader of these points; it may include voxelization/color_in_cell.glsl.
 * @param cellsPerTriangle the largest number of cells that a fine triangle meets. */
osg::ref_ptr<osg::Program> getExactCellsProgram(const char* name, const char* fragmentShader, int cellsPerTriangle);

/** Draw all fine triangles with such a program, which must be applied. Uses texture unit 1.
 * @param bindSurface called for each batch before its triangles are drawn. */
void drawExactCells(osg::State& state, const Legolization& work,
                    const std::function<void(const GridBatch&)>& bindSurface);

} // namespace osgLego
