#pragma once

#include <cstdint>
#include <string>

#include <osg/Geometry>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego::test
{

/** One triangle, initially white. */
osg::ref_ptr<osg::Geometry> createTriangle(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c);
/** Its corners are the origin, (1, 0, 0) and (0, 1, 0). */
osg::ref_ptr<osg::Geometry> createUnitTriangle();

/** A sphere of radius 1, coloured by position, of 2 * rings * rings quads, each of two triangles. */
osg::ref_ptr<osg::Node> createSphere(int rings = 24);

/** A horizontal torus of radii 1 and 0.4, with a smooth repeating texture. */
osg::ref_ptr<osg::Node> createTorus();

/** A box of 2 x 1.4 x 0.01, coloured by position, whose top and bottom share a cell. */
osg::ref_ptr<osg::Node> createThinPlate();

/** Random long thin triangles in a cube of side 2, each of a different colour; equal seeds give equal triangles. */
osg::ref_ptr<osg::Node> createSliverSoup(int count = 100, std::uint32_t seed = 7);

/** White triangles with two corners so close together that they coincide in single precision. */
osg::ref_ptr<osg::Node> createCoincidingCorners();

/** The Stanford bunny, or null if it was not downloaded. */
osg::ref_ptr<osg::Node> readBunny();

/** A bridge on two narrow posts. In 68 cells of solid bricks, it needs a submodel of more than 150 parts, since each
 * post tips over with a part of the bridge alone. */
osg::ref_ptr<osg::Node> createBridge();

/** A table on four legs. In plates of one colour, at most 750, its shell is most like it, but the top of that is a
 * submodel of more than 150 parts. */
osg::ref_ptr<osg::Node> createFourLeggedTable();

} // namespace osgLego::test
