#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A cell to be covered by a part. Layouts have coordinates of their own: x and y horizontal, z upwards. */
struct LayoutCell
{
    static constexpr std::uint16_t ANY_COLOR = 0xffff; //!< an interior cell: it takes the colour of its part

    std::array<std::uint16_t, 3> place{};
    std::uint16_t color = ANY_COLOR; //!< an index into LayoutProblem::colors

    bool operator==(const LayoutCell&) const = default;
};

/** The sizes in which a colour exists: bit i stands for PART_SIZES[i]. */
struct LayoutColor
{
    std::uint16_t bricks = 0x7ff;
    std::uint16_t plates = 0x7ff;

    bool operator==(const LayoutColor&) const = default;
};

/** Cells, and the parts that may cover them. */
struct LayoutProblem
{
    glm::ivec3 size{0};              //!< each `place` is in [0, size)
    std::vector<LayoutCell> cells;   //!< sorted by z, y and x; each place occurs once
    std::vector<LayoutColor> colors; //!< at least one
    /** False: a cell is as high as a brick. True: as high as a plate, and three plates may become a brick. */
    bool isOfPlates = false;
    bool isHollow = false; //!< whether the cells are a shell, with empty cells inside

    /** The number of cells that may have any colour. */
    std::size_t countInterior() const
    {
        return static_cast<std::size_t>(std::count_if(
            cells.begin(), cells.end(), [](const LayoutCell& cell) { return cell.color == LayoutCell::ANY_COLOR; }));
    }
    /** Whether the inside of a surface is filled. */
    bool isSolid() const { return !isHollow && countInterior() > 0; }
};

/** A part in the coordinates of a layout. */
struct LaidPart
{
    std::array<std::uint16_t, 3> place{}; //!< its lowest cell
    std::array<std::uint8_t, 3> size{1, 1, 1};
    std::uint16_t color = 0; //!< an index into LayoutProblem::colors

    bool operator==(const LaidPart&) const = default;
};

/** The order of cells and of parts: by z, y and x of their place. */
template <typename Item>
bool isPlacedBefore(const Item& item, const Item& other)
{
    return std::tie(item.place[2], item.place[1], item.place[0]) <
           std::tie(other.place[2], other.place[1], other.place[0]);
}

/** A layout of all cells. */
using LaidParts = std::vector<LaidPart>;

} // namespace osgLego
