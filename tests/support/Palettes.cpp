#include "Palettes.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace osgLego
{

osg::ref_ptr<const Palette> createPalette(std::vector<PaletteColor> colors)
{
    std::string error;
    osg::ref_ptr<const Palette> palette = Palette::create(std::move(colors), error);
    if (!palette) throw std::invalid_argument(error);
    return palette;
}

} // namespace osgLego
