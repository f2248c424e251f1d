#pragma once

#include <osg/StateAttribute>

namespace osgLego
{

/** The override value of state without which a drawable can't draw, such as the program of a pass: it replaces state
 * sets below it (OVERRIDE), and state sets above it that override do not replace it (PROTECTED). */
constexpr osg::StateAttribute::OverrideValue OVERRIDE_PROTECTED =
    osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;

} // namespace osgLego
