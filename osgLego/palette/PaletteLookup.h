#pragma once

#include <osgLego/Palette.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include <osg/ref_ptr>

namespace osgLego
{

/** The colours that bricks may have: those of a palette, or any.
 *
 * shaders/extraction/palette_color.glsl does the same on the GPU, with the same results.
 *
 * Immutable; may be called from any thread.
 */
class PaletteLookup
{
public:
    /** Any colour. */
    PaletteLookup() = default;
    /** The colours of a palette; any if it is null. @param dithers whether to imitate those between them. */
    explicit PaletteLookup(const osg::ref_ptr<const Palette>& palette, bool dithers = false) :
        _palette(palette), _dithers(dithers)
    {
    }

    bool operator==(const PaletteLookup&) const = default;

    bool hasPalette() const { return _palette.valid(); }
    /** The palette; null if any colour is allowed. */
    const Palette* getPalette() const { return _palette.get(); }
    /** Whether colours between those of the palette are imitated. */
    bool getDithers() const { return _dithers; }

    /** The index of the palette's colour for a brick in a cell whose surface has some colour. Needs a palette. */
    std::size_t find(const std::array<std::uint8_t, 3>& color, const std::array<std::uint16_t, 3>& cell) const
    {
        return _dithers ? _palette->findDithered(color, cell) : _palette->findNearest(color);
    }

    /** That colour; without a palette, the colour of the surface. */
    std::array<std::uint8_t, 3> getColor(const std::array<std::uint8_t, 3>& color,
                                         const std::array<std::uint16_t, 3>& cell) const
    {
        return _palette ? _palette->getColors()[find(color, cell)].color : color;
    }

private:
    osg::ref_ptr<const Palette> _palette;
    bool _dithers = false;
};

} // namespace osgLego
