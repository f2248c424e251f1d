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
 * May be called from any thread. The caller owns nodes, drawables and state sets; all cars share their arrays, indices,
 * textures and materials, which may be replaced, but must not be changed. */
osg::ref_ptr<osg::Node> createRacingCar();

} // namespace osgLego
