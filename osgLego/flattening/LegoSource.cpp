#include <osgLego/flattening/LegoSource.h>

namespace osgLego
{

osg::ref_ptr<LegoSource> LegoSource::create(const SceneTriangles& scene, const LegoSettings& settings,
                                            std::string& error)
{
    const SettingsPalette palette = SettingsPalette::read(settings);
    error = palette.error;
    return error.empty() ? create(*GridTriangles::create(scene, settings), settings, palette, error) : nullptr;
}

osg::ref_ptr<LegoSource> LegoSource::create(const GridTriangles& triangles, const LegoSettings& settings,
                                            const SettingsPalette& palette, std::string& error)
{
    error = palette.error;
    if (!error.empty()) return nullptr;
    osg::ref_ptr<LegoSource> source = new LegoSource;
    source->settings = settings;
    source->triangles = &triangles;
    source->lookup = PaletteLookup(paletteOf(settings, palette.palette, *source->triangles), settings.colors.dither);
    return source;
}

} // namespace osgLego
