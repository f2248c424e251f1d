#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/Part.h>

#include <span>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create lines on the table below parts, which divide it into squares, each a stud wide. A builder who lays pieces
 * beside each other counts these squares between them.
 *
 * The lines extend one stud beyond the parts on the table, in the grid's model coordinates.
 *
 * Uses no GL. May be called from any thread.
 * @param grid of bricks or plates.
 * @param parts at least one.
 * @param isUpsideDown whether the studs of the parts are on the table. */
osg::ref_ptr<osg::Node> createTableGrid(const BrickGrid& grid, std::span<const Part> parts, bool isUpsideDown);

} // namespace osgLego
