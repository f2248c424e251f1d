#pragma once

#include <osgLego/Export.h>
#include <osgLego/PaletteColor.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

struct LegoSettings;

/** A list of colours in which models may be built, and the nearest of them for any colour.
 *
 * "Nearest" is the least colour difference CIEDE2000 (Sharma, Wu and Dalal 2005), with the hue of OKLab for vivid
 * blues and darker, redder vivid yellows: otherwise the blue of displays would become purple, and their yellow cream.
 * Nearest colours are looked up in a table of 64 x 64 x 64 entries, which is the same on the CPU and on the GPU.
 *
 * Usage:
 *
 *     std::string error;
 *     const osg::ref_ptr<const osgLego::Palette> palette = osgLego::Palette::read("ldraw", error);
 *     if (palette) std::cout << palette->getColors()[palette->findNearest({200, 30, 30})].name << '\n';
 *
 * Uses no GL. Immutable once created; every function may be called from any thread.
 */
class OSGLEGO_EXPORT Palette : public osg::Referenced
{
public:
    static constexpr int TABLE_SIDE =
        PaletteLimits::TABLE_SIDE; //!< entries of the table along each of red, green and blue
    static constexpr std::size_t MAXIMUM_COLORS = PaletteLimits::MAXIMUM_COLORS;

    /** Create a palette of 1 to MAXIMUM_COLORS colours, or share a recent one with the same colours: tables take tens
     * of milliseconds to create.
     * @return null, with one sentence in `error`, for another number of colours. */
    static osg::ref_ptr<const Palette> create(std::vector<PaletteColor> colors, std::string& error);

    /** Read a palette: "ldraw", the solid colours in which nearly all sizes of bricks and plates were made, or a file:
     * a .csv with the columns of data/ldraw-solid-colours.csv, or LDraw's LDConfig.ldr. A file is read each
     * time.
     * @return null, with one sentence in `error` that names the file and the bad line, if it can't be read. */
    static osg::ref_ptr<const Palette> read(const std::string& nameOrFile, std::string& error);

    /** Read the palette that settings name, with all of its colours. LegoSettings::check() does not, as it reads no
     * files.
     * @return null if the settings have no palette, and, with one sentence in `error`, if it can't be read. */
    static osg::ref_ptr<const Palette> read(const LegoSettings& settings, std::string& error);

    /** All solid colours of LDraw that the library knows, in the order of their codes; palettes are parts of this list.
     */
    static std::span<const PaletteColor> getKnownColors();

    /** The difference CIEDE2000 of two sRGB colours: about 1 if it is just noticeable, and 100 for black and white. */
    static double getDifference(const std::array<std::uint8_t, 3>& color, const std::array<std::uint8_t, 3>& other);

    std::span<const PaletteColor> getColors() const { return _colors; }
    /** The index of the colour nearest to an sRGB colour. A colour of the palette is its own nearest, unless an earlier
     * one shares its entry of the table: that one is found for both. */
    std::size_t findNearest(const std::array<std::uint8_t, 3>& color) const;
    /** The index of the colour of a brick in a cell of the grid if colours between those of the palette are imitated:
     * the bricks of an even surface get one or two colours, whose mean in linear light is close to its own. Colours of
     * the palette that are their own nearest remain themselves. The first call takes as long as getMixtures(). */
    std::size_t findDithered(const std::array<std::uint8_t, 3>& color, const std::array<std::uint16_t, 3>& cell) const;
    /** The table of findNearest(): one index for each of TABLE_SIDE^3 colours, red changing fastest. */
    std::span<const std::uint8_t> getTable() const { return _table; }
    /** The table of findDithered(), in the same order. The first call computes it, in some tenths of a second of
     * processor time. */
    std::span<const PaletteMixture> getMixtures() const;

private:
    explicit Palette(std::vector<PaletteColor> colors);
    ~Palette() override = default;

    std::vector<PaletteColor> _colors;
    std::vector<std::uint8_t> _table;
    mutable std::once_flag _mixturesOnce;
    mutable std::vector<PaletteMixture> _mixtures;
};

} // namespace osgLego
