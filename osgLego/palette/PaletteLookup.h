#pragma once

#include <osgLego/Palette.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glm/vec3.hpp>
#include <osg/ref_ptr>

namespace osgLego
{

/** The colours that cells may have: those of a palette, or any.
 *
 * shaders/extraction/palette_color.glsl does the same on the GPU, with the same result.
 *
 * Immutable; may be called from any thread.
 */
class PaletteLookup
{
public:
    /** Any colour. */
    PaletteLookup() = default;
    /** The colours of a palette; any if it is null. */
    explicit PaletteLookup(osg::ref_ptr<const Palette> palette) : _palette(std::move(palette)) {}

    bool hasPalette() const { return _palette.valid(); }
    /** The palette; null if any colour is allowed. */
    const Palette* getPalette() const { return _palette.get(); }

    /** The index of the palette's colour for a cell whose surface has some colour. Needs a palette. */
    std::size_t find(const std::array<std::uint8_t, 3>& color) const { return _palette->findNearest(color); }

    /** That colour; without a palette, the colour of the surface. */
    std::array<std::uint8_t, 3> getColor(const std::array<std::uint8_t, 3>& color) const
    {
        return _palette ? _palette->getColors()[find(color)].color : color;
    }

private:
    osg::ref_ptr<const Palette> _palette;
};

} // namespace osgLego
