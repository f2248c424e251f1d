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
 * 128 x 128 x 128 some millions. May be called from any thread. */
OSGLEGO_EXPORT osg::ref_ptr<osg::Geometry> createBrickGeometry(const BrickModel& model);

/** Hand the open faces of the bricks, without studs, to a functor, as quads in model units: for picking. */
OSGLEGO_EXPORT void acceptBrickFaces(const BrickModel& model, osg::PrimitiveFunctor& functor);

} // namespace osgLego
