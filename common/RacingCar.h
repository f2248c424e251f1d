#pragma once

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** The built-in model, for trying things out without a file: a racing car as they were in the nineteen-sixties.
 *
 * Made by code, the same on every call: about 4.2 units long (metres), Z up, its nose towards -X, standing on z = 0.
 * The body carries a texture, the tyres vertex colours, rims, wings and pipes Materials; the four wheels share their
 * subgraphs. `sample.legolize` is this one in bricks.
 *
 * May be called from any thread; the caller owns the result. */
osg::ref_ptr<osg::Node> createRacingCar();

} // namespace osgLego
