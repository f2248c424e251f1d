#include <osgLego/palette/SettingsPalette.h>

namespace osgLego
{

osg::ref_ptr<const Palette> readPalette(const LegoSettings& settings, std::string& error)
{
    const std::string name = settings.getPalette();
    return name == "none" ? nullptr : Palette::read(name, error);
}

std::string findPaletteError(const LegoSettings& settings)
{
    std::string error;
    readPalette(settings, error);
    return error;
}

} // namespace osgLego
