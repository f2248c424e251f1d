#include <osgLego/flattening/SourcePalette.h>

#include <osgLego/flattening/SourceColors.h>
#include <osgLego/palette/ColorChoice.h>

namespace osgLego
{

osg::ref_ptr<const Palette> paletteOf(const LegoSettings& settings, const GridTriangles& triangles, std::string& error)
{
    const osg::ref_ptr<const Palette> palette = Palette::read(settings, error);
    if (!palette || !settings.colors.count || *settings.colors.count >= palette->getColors().size()) return palette;
    return chooseColors(*palette, histogramOf(triangles), *settings.colors.count);
}

} // namespace osgLego
