#pragma once

#include <osgLego/palette/TableBlock.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The sRGB colour in the middle of an entry of Palette::getTable(). */
inline std::array<std::uint8_t, 3> middleOfEntry(std::size_t entry)
{
    constexpr std::size_t SIDE = PaletteLimits::TABLE_SIDE;
    constexpr std::size_t WIDTH = 256 / SIDE;
    const auto middleOf = [](std::size_t step) { return static_cast<std::uint8_t>(WIDTH * step + WIDTH / 2); };
    return {middleOf(entry % SIDE), middleOf(entry / SIDE % SIDE), middleOf(entry / SIDE / SIDE)};
}

/** The places (toMatchingLab()) of the middles of all entries of Palette::getTable(), which are the same for every
 * palette. Immutable; may be used from any thread. */
class EntryPlaces
{
public:
    static const EntryPlaces& get();

    const glm::dvec3& operator[](std::size_t entry) const { return _places[entry]; }
    /** The difference (CIEDE2000) between the middle entry of a block and the one that is farthest from it. */
    double getRadius(const TableBlock& block) const { return _radii[block.getIndex()]; }

private:
    EntryPlaces();

    double findRadius(const TableBlock& block) const;

    std::vector<glm::dvec3> _places;
    std::vector<double> _radii;
};

} // namespace osgLego
