#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>

#include <osg/Geometry>
#include <osg/PrimitiveSet>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create plain triangles for the bricks, in model units, with the same faces and studs as the geometry shader: for
 * code that can't use the shader, such as writers of other file formats.
 *
 * The geometry has vertices, normals, one colour per vertex, and indexed triangles. A brick with a stud has up to 58
 * triangles; a grid of 128 x 128 x 128 cells can have several million. The triangles are in the order of
 * BrickModel::getBricks(). For each brick there are two triangles for each open side, in the order of BrickSide, and,
 * if the upper side is open, the 46 triangles of the stud. As long as this order is kept, BrickIntersection::find can
 * identify the brick of a triangle; for this purpose the model is the user data of the geometry.
 *
 * If the cells are joined to parts, the triangles are still those of the cells. Faces of one part are not merged,
 * because larger faces would have corners of other faces on their edges, where cracks appear, and because most
 * triangles are those of studs. May be called from any thread. */
OSGLEGO_EXPORT osg::ref_ptr<osg::Geometry> createBrickGeometry(const BrickModel& model);

/** Pass the same triangles in the same order to a functor, without creating a geometry of them all: for picking. May be
 * called from any thread. */
OSGLEGO_EXPORT void acceptBrickTriangles(const BrickModel& model, osg::PrimitiveFunctor& functor);

} // namespace osgLego
