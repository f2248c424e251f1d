#pragma once

#include <cstdint>
#include <string>

#include <osg/Geometry>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego::test
{

/** One triangle, white unless coloured later. */
osg::ref_ptr<osg::Geometry> createTriangle(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c);

/** A sphere of radius 1, coloured by its place, of 2 * rings * rings quads cut in two. */
osg::ref_ptr<osg::Node> createSphere(int rings = 24);

/** A torus lying flat, radii 1 and 0.4, textured with a smooth picture that repeats. */
osg::ref_ptr<osg::Node> createTorus();

/** A box of 2 x 1.4 x 0.01, coloured by its place: two sheets of it within one cell. */
osg::ref_ptr<osg::Node> createThinPlate();

/** Long thin triangles in a cube of side 2, without order, each of another colour; the same for the same seed. */
osg::ref_ptr<osg::Node> createSliverSoup(int count = 100, std::uint32_t seed = 7);

/** White triangles, two corners of each so near each other that they fall together once they are rounded to floats. */
osg::ref_ptr<osg::Node> createCoincidingCorners();

/** The Stanford bunny, if the set-up of the tests could fetch it; else null. */
osg::ref_ptr<osg::Node> readBunny();

} // namespace osgLego::test
