#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A real brick or plate in a model: a box of cells in one colour. PartType names it.
 *
 * A plain value without GL; every function may be called from any thread. */
struct Part
{
    static constexpr std::int32_t NO_CODE = -1; //!< a colour that is in no palette

    std::array<std::uint16_t, 3> cell{};       //!< the lowest of its cells, in the grid
    std::array<std::uint8_t, 3> size{1, 1, 1}; //!< in cells along the axes of the grid, each at least 1
    std::array<std::uint8_t, 3> color{};       //!< red, green, blue (sRGB)
    std::int32_t colorCode = NO_CODE;          //!< LDraw's code of the colour

    glm::ivec3 getCell() const { return {cell[0], cell[1], cell[2]}; }
    glm::ivec3 getSize() const { return {size[0], size[1], size[2]}; }

    bool operator==(const Part&) const = default;
};

} // namespace osgLego
