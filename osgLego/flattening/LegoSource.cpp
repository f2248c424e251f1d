#include <osgLego/flattening/LegoSource.h>

#include <osgLego/flattening/SourcePalette.h>

namespace osgLego
{

osg::ref_ptr<LegoSource> LegoSource::create(const SceneTriangles& scene, const LegoSettings& settings,
                                            std::string& error)
{
    osg::ref_ptr<LegoSource> source = new LegoSource;
    source->settings = settings;
    source->triangles = GridTriangles::create(scene, settings);
    source->lookup = PaletteLookup(paletteOf(settings, *source->triangles, error), settings.colors.dither);
    return error.empty() ? source : nullptr;
}

} // namespace osgLego
