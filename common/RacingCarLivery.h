#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

// All cars share these images while any car has them: nodes whose sources have the same images share what they make of
// these, which is larger than a car. Functions may be called from any thread.

/** The paint of the racing car's body seen from above: s from nose to tail, t from right to left. */
osg::ref_ptr<osg::Image> getRacingCarLivery();

/** A chequered flag, for the rear wing. */
osg::ref_ptr<osg::Image> getChequeredFlag();

} // namespace osgLego
