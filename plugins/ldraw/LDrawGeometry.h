#pragma once

#include "LDrawColors.h"

#include <span>

#include <osg/Geode>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create a drawable of surfaces, lit from both sides, in millimetres and with z upwards.
 * @param triangles in LDU, in the coordinates of a main model. */
osg::ref_ptr<osg::Geode> createLDrawGeometry(std::span<const LDrawTriangle> triangles, const LDrawColors& colors);

} // namespace osgLego
