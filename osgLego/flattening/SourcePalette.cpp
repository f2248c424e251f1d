#include <osgLego/flattening/SourcePalette.h>

#include <osgLego/flattening/SourceColors.h>
#include <osgLego/palette/ColorChoice.h>

#include <algorithm>

namespace osgLego
{

SettingsPalette SettingsPalette::read(const LegoSettings& settings)
{
    SettingsPalette read;
    read.palette = Palette::read(settings, read.error);
    return read;
}

bool SettingsPalette::operator==(const SettingsPalette& other) const
{
    if (error != other.error || palette.valid() != other.palette.valid()) return false;
    return palette == other.palette || std::ranges::equal(palette->getColors(), other.palette->getColors());
}

osg::ref_ptr<const Palette> paletteOf(const LegoSettings& settings, const Palette* palette,
                                      const GridTriangles& triangles)
{
    if (!palette || !settings.colors.count || *settings.colors.count >= palette->getColors().size()) return palette;
    return chooseColors(*palette, histogramOf(triangles), *settings.colors.count);
}

} // namespace osgLego
