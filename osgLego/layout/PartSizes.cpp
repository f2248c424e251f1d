#include <osgLego/layout/PartSizes.h>

#include <osgLego/PartType.h>

#include <algorithm>
#include <cstddef>

namespace osgLego
{

namespace
{

constexpr std::int8_t NO_SIZE = -1;
using SizeTable = std::array<std::array<std::int8_t, PartSizes::LONGEST + 1>, PartSizes::LONGEST + 1>;

constexpr SizeTable makeSizeTable()
{
    SizeTable table{};
    for (auto& row : table)
        row.fill(NO_SIZE);
    for (std::size_t i = 0; i < PART_SIZES.size(); ++i)
    {
        const auto shorter = static_cast<std::size_t>(PART_SIZES[i][0]);
        const auto longer = static_cast<std::size_t>(PART_SIZES[i][1]);
        table[shorter][longer] = table[longer][shorter] = static_cast<std::int8_t>(i);
    }
    return table;
}

/** The index in PART_SIZES of sizes in either order. */
constexpr SizeTable SIZE_INDICES = makeSizeTable();

} // namespace

PartSizes::PartSizes(const LayoutProblem& problem) : _heights(problem.isOfPlates ? 2 : 1, 1)
{
    std::array<std::uint16_t, 2> any{};
    for (const LayoutColor& color : problem.colors)
    {
        const std::uint16_t none = 0;
        _masks.push_back(problem.isOfPlates ? std::array{color.plates, color.bricks} : std::array{color.bricks, none});
        any[0] |= _masks.back()[0];
        any[1] |= _masks.back()[1];
    }
    _masks.push_back(any);
    if (problem.isOfPlates) _heights.back() = BRICK_PLATES;
}

bool PartSizes::isMade(const PartShape& shape, std::uint16_t color) const
{
    const std::int8_t size = SIZE_INDICES[shape.width][shape.depth];
    if (size == NO_SIZE) return false;
    if (shape.height != 1 && shape.height != _heights.back()) return false;
    const std::size_t index = std::min<std::size_t>(color, _masks.size() - 1);
    return (_masks[index][shape.height == 1 ? 0 : 1] >> size & 1) != 0;
}

bool PartSizes::isAllowed(const PartShape& shape, std::uint16_t color) const
{
    return shape == PartShape{} || isMade(shape, color);
}

} // namespace osgLego
