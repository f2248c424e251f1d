#pragma once

#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** Two numbers from 0 to 1 for each pixel of a square of 64 x 64, the same on every run, such that neighbours have
 * numbers that are far apart: Roberts' R2 sequence along a Hilbert curve. May
 * be called from any thread. */
osg::ref_ptr<osg::Texture2D> createOcclusionNoise();

} // namespace osgLego
