#pragma once

#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create noise: two numbers from 0 to 1 for each of 64 x 64 pixels, the same in every run. Neighbours have very
 * different numbers: Roberts' R2 sequence along a Hilbert curve. May be called from any thread. */
osg::ref_ptr<osg::Texture2D> createOcclusionNoise();

} // namespace osgLego
