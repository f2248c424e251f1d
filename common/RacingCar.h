#pragma once

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create the built-in model, a racing car of the 1960s, for demonstrations that need no file.
 *
 * Every call creates the same model: about 4.2 units (metres) long, Z up, standing on z = 0 with its nose towards -X.
 * The body has a texture, the tyres have vertex colours, and the rims, wings and pipes have Materials; the four wheels
 * share their subgraphs. `sample.legolize` shows it in bricks.
 *
 * May be called from any thread; the caller owns the result, except for the images of its textures, which all cars
 * share. */
osg::ref_ptr<osg::Node> createRacingCar();

} // namespace osgLego
