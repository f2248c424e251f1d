#include <osgLego/flattening/LegoSource.h>

namespace osgLego
{

osg::ref_ptr<LegoSource> LegoSource::create(const SceneTriangles& scene, const LegoSettings& settings,
                                            std::string& error)
{
    return create(scene, settings, SettingsPalette::read(settings), error);
}

osg::ref_ptr<LegoSource> LegoSource::create(const SceneTriangles& scene, const LegoSettings& settings,
                                            const SettingsPalette& palette, std::string& error)
{
    error = palette.error;
    if (!error.empty()) return nullptr;
    osg::ref_ptr<LegoSource> source = new LegoSource;
    source->settings = settings;
    source->triangles = GridTriangles::create(scene, settings);
    source->lookup = PaletteLookup(paletteOf(settings, palette.palette, *source->triangles), settings.colors.dither);
    return source;
}

} // namespace osgLego
