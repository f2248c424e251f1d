#include "LDrawBricks.h"

#include <algorithm>
#include <bitset>
#include <limits>
#include <unordered_map>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr int BRICK_PLATES = 3;

struct PlacedBox
{
    const LDrawPart* part;
    LatticeBox box;
};

struct Extent
{
    glm::ivec3 lowest{std::numeric_limits<int>::max()};
    glm::ivec3 end{std::numeric_limits<int>::min()};
    bool areBricks = true; // all of them bricks, in common layers

    explicit Extent(const std::vector<PlacedBox>& boxes)
    {
        for (const PlacedBox& placed : boxes)
        {
            lowest = glm::min(lowest, placed.box.place);
            end = glm::max(end, placed.box.place + placed.box.size);
        }
        areBricks = std::all_of(boxes.begin(), boxes.end(),
                                [this](const PlacedBox& placed) {
                                    return placed.box.size.z == BRICK_PLATES &&
                                           (placed.box.place.z - lowest.z) % BRICK_PLATES == 0;
                                });
    }
};

/** Records which cells are taken, in blocks, so that parts far from each other need no memory for the cells between
 * them. */
class TakenCells
{
public:
    /** Take the cells of a box. @return false, and no change, if one of them is taken. */
    bool take(const glm::ivec3& place, const glm::ivec3& size)
    {
        if (!forEach(place, size, [](auto& block, std::size_t bit) { return !block[bit]; })) return false;
        return forEach(place, size,
                       [](auto& block, std::size_t bit)
                       {
                           block.set(bit);
                           return true;
                       });
    }

private:
    static constexpr int SIDE = 8;
    using Block = std::bitset<SIDE * SIDE * SIDE>;

    template <typename Function>
    bool forEach(const glm::ivec3& place, const glm::ivec3& size, const Function& function)
    {
        for (int z = place.z; z < place.z + size.z; ++z)
            for (int y = place.y; y < place.y + size.y; ++y)
                for (int x = place.x; x < place.x + size.x; ++x)
                {
                    const auto blockOf = [](int cell) { return static_cast<std::uint64_t>(cell / SIDE); };
                    const int bit = x % SIDE + SIDE * (y % SIDE + SIDE * (z % SIDE));
                    Block& block = _blocks[blockOf(x) << 40 | blockOf(y) << 20 | blockOf(z)];
                    if (!function(block, static_cast<std::size_t>(bit))) return false;
                }
        return true;
    }

    std::unordered_map<std::uint64_t, Block> _blocks;
};

/** Leave out boxes with a cell of an earlier one, before the grid is chosen: it should fit the other parts alone. */
std::vector<PlacedBox> removeOverlaps(const std::vector<PlacedBox>& boxes, std::vector<LDrawPart>& overlapping)
{
    const glm::ivec3 lowest = Extent(boxes).lowest;
    TakenCells taken;
    std::vector<PlacedBox> kept;
    for (const PlacedBox& placed : boxes)
    {
        if (taken.take(placed.box.place - lowest, placed.box.size))
            kept.push_back(placed);
        else
            overlapping.push_back(*placed.part);
    }
    return kept;
}

std::string findObstacle(const glm::ivec3& cells)
{
    constexpr int UP = 2;
    if (GridLimits::contain(cells, UP)) return {};
    return "its parts reach over " + std::to_string(cells.x) + " x " + std::to_string(cells.y) + " x " +
           std::to_string(cells.z) + " cells; expected at most " + GridLimits::describe(UP);
}

BrickGrid createGrid(const LDrawLattice& lattice, const Extent& extent)
{
    const glm::ivec3 divisor(1, 1, extent.areBricks ? BRICK_PLATES : 1);
    BrickGrid grid;
    grid.upAxis = UpAxis::Z;
    grid.dimensions = (extent.end - extent.lowest) / divisor;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double cell = LDrawBricks::MILLIMETRES * LATTICE_CELL[static_cast<std::size_t>(axis)];
        grid.cellSize[axis] = cell * divisor[axis];
        grid.origin[axis] = LDrawBricks::MILLIMETRES * lattice.getOrigin()[axis] + cell * extent.lowest[axis];
    }
    return grid;
}

Part toPart(const glm::ivec3& cell, const glm::ivec3& size)
{
    Part part;
    for (int axis = 0; axis < 3; ++axis)
    {
        part.cell[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(cell[axis]);
        part.size[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(size[axis]);
    }
    return part;
}

void setColor(Part& part, std::int32_t value, const LDrawColors& colors, std::set<std::int32_t>& unknown)
{
    const std::optional<LDrawColors::Color> color = colors.find(value);
    part.color = color.value_or(LDrawColors::UNKNOWN);
    if (LDrawColors::isDirect(value) || value == LDrawDocument::MAIN_COLOR) return;
    part.colorCode = value; // kept for writers, even if its colour is not known
    if (!color) unknown.insert(value);
}

} // namespace

LDrawBricks LDrawBricks::create(std::span<const LDrawPart> parts, const LDrawColors& colors, std::string& error)
{
    LDrawBricks result;
    const LDrawLattice lattice = LDrawLattice::find(parts);
    std::vector<PlacedBox> boxes;
    for (const LDrawPart& part : parts)
    {
        if (const std::optional<LatticeBox> box = lattice.toBox(part))
            boxes.push_back({&part, *box});
        else
            result.offLattice.push_back(part);
    }
    if (boxes.empty()) return result;
    boxes = removeOverlaps(boxes, result.overlapping);
    const Extent extent(boxes);
    const BrickGrid grid = createGrid(lattice, extent);
    error = findObstacle(grid.dimensions);
    if (!error.empty()) return result;

    std::vector<Part> laid;
    const glm::ivec3 divisor(1, 1, extent.areBricks ? BRICK_PLATES : 1);
    for (const PlacedBox& placed : boxes)
    {
        Part& part = laid.emplace_back(toPart((placed.box.place - extent.lowest) / divisor, placed.box.size / divisor));
        setColor(part, placed.part->color, colors, result.unknownColors);
    }
    result.model = BrickModel::createOfParts(grid, std::move(laid));
    return result;
}

} // namespace osgLego
