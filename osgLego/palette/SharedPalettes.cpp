#include <osgLego/palette/SharedPalettes.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace osgLego
{

osg::ref_ptr<const Palette> sharePalette(std::vector<PaletteColor> colors, std::string& error)
{
    static std::mutex mutex;
    static std::vector<osg::ref_ptr<const Palette>> palettes;
    const auto hasColors = [&](const osg::ref_ptr<const Palette>& palette)
    { return std::ranges::equal(palette->getColors(), colors); };
    {
        const std::scoped_lock lock(mutex);
        const auto found = std::find_if(palettes.begin(), palettes.end(), hasColors);
        if (found != palettes.end()) return *found;
    }
    // No lock is held here: a table is created on threads of oneTBB, which may run other tasks that need a palette.
    const osg::ref_ptr<const Palette> palette = Palette::create(colors, error);
    if (!palette) return nullptr;
    const std::scoped_lock lock(mutex);
    const auto found = std::find_if(palettes.begin(), palettes.end(), hasColors);
    if (found != palettes.end()) return *found;
    constexpr std::size_t MOST_PALETTES = 16; // a palette takes a quarter of a megabyte
    if (palettes.size() >= MOST_PALETTES) palettes.clear();
    palettes.push_back(palette);
    return palette;
}

} // namespace osgLego
