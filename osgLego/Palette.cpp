#include <osgLego/Palette.h>

#include <osgLego/LegoSettings.h>
#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/Dither.h>
#include <osgLego/palette/KnownColors.h>
#include <osgLego/palette/MixtureTable.h>
#include <osgLego/palette/NearestTable.h>
#include <osgLego/palette/PaletteFile.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace osgLego
{

namespace
{

/** The palettes that were used last. Every function may be called from any thread. */
class RecentPalettes
{
public:
    static RecentPalettes& instance()
    {
        static RecentPalettes palettes;
        return palettes;
    }

    /** @return null if there is no palette with these colours. */
    osg::ref_ptr<const Palette> find(std::span<const PaletteColor> colors)
    {
        const std::scoped_lock lock(_mutex);
        return findLocked(colors);
    }

    /** @return the palette that another thread has added meanwhile if its colours are the same. */
    osg::ref_ptr<const Palette> add(const osg::ref_ptr<const Palette>& palette)
    {
        constexpr std::size_t MOST_PALETTES = 16; // a palette takes a quarter of a megabyte
        const std::scoped_lock lock(_mutex);
        if (const osg::ref_ptr<const Palette> found = findLocked(palette->getColors())) return found;
        if (_palettes.size() >= MOST_PALETTES) _palettes.erase(_palettes.begin());
        _palettes.push_back(palette);
        return palette;
    }

private:
    /** A palette that is found becomes the last one, which is kept for longest. */
    osg::ref_ptr<const Palette> findLocked(std::span<const PaletteColor> colors)
    {
        const auto found = std::ranges::find_if(_palettes, [&](const osg::ref_ptr<const Palette>& palette)
                                                { return std::ranges::equal(palette->getColors(), colors); });
        if (found == _palettes.end()) return nullptr;
        std::rotate(found, found + 1, _palettes.end());
        return _palettes.back();
    }

    std::mutex _mutex;
    std::vector<osg::ref_ptr<const Palette>> _palettes;
};

} // namespace

Palette::Palette(std::vector<PaletteColor> colors) : _colors(std::move(colors)), _table(makeNearestTable(_colors)) {}

osg::ref_ptr<const Palette> Palette::create(std::vector<PaletteColor> colors, std::string& error)
{
    if (colors.empty() || colors.size() > MAXIMUM_COLORS)
    {
        error = "the palette has " + std::to_string(colors.size()) + " colours; expected 1 to " +
                std::to_string(MAXIMUM_COLORS);
        return nullptr;
    }
    RecentPalettes& recent = RecentPalettes::instance();
    if (osg::ref_ptr<const Palette> palette = recent.find(colors)) return palette;
    // No lock is held here: a table is created on threads of oneTBB, which may run other tasks that need a palette.
    return recent.add(new Palette(std::move(colors)));
}

osg::ref_ptr<const Palette> Palette::read(const std::string& nameOrFile, std::string& error)
{
    std::vector<PaletteColor> colors =
        nameOrFile == "ldraw" ? selectDefaultColors() : readPaletteFile(nameOrFile, error);
    return colors.empty() ? nullptr : create(std::move(colors), error);
}

osg::ref_ptr<const Palette> Palette::read(const LegoSettings& settings, std::string& error)
{
    const std::string name = settings.getPalette();
    return name == "none" ? nullptr : read(name, error);
}

std::span<const PaletteColor> Palette::getKnownColors()
{
    return osgLego::getKnownColors();
}

double Palette::getDifference(const std::array<std::uint8_t, 3>& color, const std::array<std::uint8_t, 3>& other)
{
    return ciede2000(toCieLab(color), toCieLab(other));
}

std::size_t Palette::findNearest(const std::array<std::uint8_t, 3>& color) const
{
    return _table[tableEntryOf(color)];
}

std::size_t Palette::findDithered(const std::array<std::uint8_t, 3>& color,
                                  const std::array<std::uint16_t, 3>& cell) const
{
    const PaletteMixture& mixture = getMixtures()[tableEntryOf(color)];
    return Dither::thresholdAt(cell[0], cell[1], cell[2]) < mixture.share ? mixture.second : mixture.first;
}

std::span<const PaletteMixture> Palette::getMixtures() const
{
    std::call_once(_mixturesOnce, [this] { _mixtures = makeMixtureTable(_colors, _table); });
    return _mixtures;
}

} // namespace osgLego
