#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/Palette.h>
#include <osgLego/flattening/GridTriangles.h>

#include <string>

namespace osgLego
{

/** The palette of a source: the one that the settings name, or the colours of it that suit the source best if the
 * settings limit their number. May be called from any thread.
 * @return null if the settings have no palette, and, with one sentence in `error`, if it can't be read. */
osg::ref_ptr<const Palette> paletteOf(const LegoSettings& settings, const GridTriangles& triangles, std::string& error);

} // namespace osgLego
