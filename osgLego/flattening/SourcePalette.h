#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/Palette.h>
#include <osgLego/flattening/GridTriangles.h>

#include <string>

#include <osg/ref_ptr>

namespace osgLego
{

/** The palette that settings name, as it was when they were set: later changes of its file have no effect. */
struct SettingsPalette
{
    osg::ref_ptr<const Palette> palette; //!< null if the settings have no palette, or if there is an error
    std::string error;                   //!< one sentence if the palette can't be read; otherwise empty

    /** Read it. May be called from any thread. */
    static SettingsPalette read(const LegoSettings& settings);

    /** Whether both have the same colours and the same error. */
    bool operator==(const SettingsPalette& other) const;
};

/** The palette of a source: the given one, or the colours of it that suit the source best if the settings limit their
 * number. May be called from any thread. @param palette null if the settings have none; then null is returned. */
osg::ref_ptr<const Palette> paletteOf(const LegoSettings& settings, const Palette* palette,
                                      const GridTriangles& triangles);

} // namespace osgLego
