#pragma once

#include <osgLego/BrickModel.h>

#include <vector>

#include <glm/vec3.hpp>
#include <osg/ref_ptr>

namespace osgLego::test
{

/** A brick of the given size in studs at a place in studs and layers. */
Part createBrick(const glm::ivec3& place, int width, int depth);

/** A model of parts in a grid of bricks, or of plates. */
osg::ref_ptr<const BrickModel> createPartModel(std::vector<Part> parts, double cellHeight = 1.2);

/** A pile of random bricks, each on studs of others or on the ground; higher if there are many. Throws
 * std::invalid_argument if it would be higher than 128 layers. */
osg::ref_ptr<const BrickModel> createRandomTower(unsigned int seed, int numParts);

/** A brick 1 x 8 with its first stud on a brick 1 x 1, and bricks piled on its last stud, 1 x 3 across and 1 x 1. */
osg::ref_ptr<const BrickModel> createLoadedCantilever(int numBricks1x3, int numBricks1x1);

/** The parts of a model, in a grid whose up axis is z, as another model: turned by a quarter about the up axis. */
osg::ref_ptr<const BrickModel> turn(const BrickModel& model);
/** The same, mirrored along x. */
osg::ref_ptr<const BrickModel> mirror(const BrickModel& model);
/** The same, with y as the up axis. */
osg::ref_ptr<const BrickModel> tilt(const BrickModel& model);

} // namespace osgLego::test
