#include <osgLego/flattening/LegoSource.h>

namespace osgLego
{

osg::ref_ptr<LegoSource> LegoSource::create(const SceneTriangles& scene, const LegoSettings& settings,
                                            std::string& error)
{
    osg::ref_ptr<const Palette> palette;
    if (settings.getPalette() != "none")
    {
        palette = Palette::read(settings.getPalette(), error);
        if (!palette) return nullptr;
    }
    osg::ref_ptr<LegoSource> source = new LegoSource;
    source->settings = settings;
    source->triangles = GridTriangles::create(scene, settings);
    source->lookup = PaletteLookup(palette);
    return source;
}

} // namespace osgLego
