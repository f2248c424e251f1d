#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>

#include <osg/Geometry>
#include <osg/PrimitiveSet>
#include <osg/ref_ptr>

namespace osgLego
{

/** The bricks as plain triangles, faces and studs as the geometry shader makes them, in model units: for programs that
 * can't run it, such as writers of other file formats.
 *
 * Vertices, normals, a colour a vertex, triangles indexed. Up to 58 triangles a brick with a stud: for a grid of
 * 128 x 128 x 128 some millions. The triangles stand in the order of BrickModel::getBricks(); those of a brick are two
 * for each open side, in the order of BrickSide, and then the 46 of its stud, if the side that is up is open. As long
 * as they keep that order, BrickIntersection::find tells which brick a triangle belongs to, for which the geometry
 * keeps the model as its user data. May be called from any thread. */
OSGLEGO_EXPORT osg::ref_ptr<osg::Geometry> createBrickGeometry(const BrickModel& model);

/** Hand the same triangles in the same order to a functor, without a geometry that holds all of them: for picking. May
 * be called from any thread. */
OSGLEGO_EXPORT void acceptBrickTriangles(const BrickModel& model, osg::PrimitiveFunctor& functor);

} // namespace osgLego
