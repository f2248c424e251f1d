#pragma once

#include <osg/StateAttribute>

namespace osgLego
{

/** The override value for state that a drawable can't draw without, such as the program of a pass: it replaces the
 * state in state sets below (OVERRIDE), and overriding state sets above do not replace it (PROTECTED). */
constexpr osg::StateAttribute::OverrideValue OVERRIDE_PROTECTED =
    osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;

} // namespace osgLego
