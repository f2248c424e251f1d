#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** The paint of the racing car's body seen from above: s from nose to tail, t from right to left. */
osg::ref_ptr<osg::Image> createRacingCarLivery();

/** A chequered flag, for the rear wing. */
osg::ref_ptr<osg::Image> createChequeredFlag();

} // namespace osgLego
