#include <osgLego/layout/LayoutModel.h>

#include <osgLego/PartType.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <unordered_map>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

std::uint32_t keyOf(const Color& color)
{
    return color[0] | static_cast<std::uint32_t>(color[1]) << 8 | static_cast<std::uint32_t>(color[2]) << 16;
}

/** Exchange y and z if y points upwards in the grid; it is its own inverse. */
template <typename Number>
std::array<Number, 3> exchangeAxes(std::array<Number, 3> vector, const BrickGrid& grid)
{
    if (grid.getUpIndex() == 1) std::swap(vector[1], vector[2]);
    return vector;
}

} // namespace

LayoutProblem createProblem(const FilledCells& cells, const BrickGrid& grid, const std::vector<PaletteColor>& colors)
{
    LayoutProblem problem;
    const auto size = exchangeAxes(std::array{grid.dimensions.x, grid.dimensions.y, grid.dimensions.z}, grid);
    problem.size = {size[0], size[1], size[2]};
    problem.isOfPlates = getCellPlates(grid) == 1;
    problem.isHollow = cells.isHollow;
    std::unordered_map<std::uint32_t, std::uint16_t> indices;
    for (const PaletteColor& color : colors)
    {
        indices.emplace(keyOf(color.color), static_cast<std::uint16_t>(problem.colors.size()));
        problem.colors.push_back({color.bricks, color.plates});
    }
    problem.cells.reserve(cells.bricks.size());
    for (std::size_t index = 0; index < cells.bricks.size(); ++index)
    {
        LayoutCell cell{exchangeAxes(cells.bricks[index].cell, grid)};
        const auto color = indices.find(keyOf(cells.bricks[index].color));
        if (!cells.isInterior[index] && color != indices.end()) cell.color = color->second;
        problem.cells.push_back(cell);
    }
    if (!std::is_sorted(problem.cells.begin(), problem.cells.end(), isPlacedBefore<LayoutCell>))
        std::sort(problem.cells.begin(), problem.cells.end(), isPlacedBefore<LayoutCell>);
    return problem;
}

LaidParts moveParts(const LaidParts& parts, const BrickGrid& from, const BrickGrid& to)
{
    const glm::ivec3 cells(glm::round((from.origin - to.origin) / to.cellSize));
    const std::array<int, 3> step = exchangeAxes(std::array{cells.x, cells.y, cells.z}, to);
    if (step == std::array{0, 0, 0}) return parts;
    LaidParts moved;
    moved.reserve(parts.size());
    for (LaidPart part : parts)
    {
        bool isInside = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            const int place = part.place[axis] + step[axis];
            isInside = isInside && place >= 0 && place <= std::numeric_limits<std::uint16_t>::max();
            part.place[axis] = static_cast<std::uint16_t>(place);
        }
        if (isInside) moved.push_back(part);
    }
    return moved;
}

std::vector<PaletteColor> collectColors(const FilledCells& cells)
{
    std::set<Color> found;
    for (std::size_t index = 0; index < cells.bricks.size(); ++index)
        if (!cells.isInterior[index]) found.insert(cells.bricks[index].color);
    std::vector<PaletteColor> colors;
    for (const Color& color : found)
    {
        if (colors.size() == LayoutCell::ANY_COLOR) break;
        colors.push_back({Part::NO_CODE, {}, color});
    }
    return colors;
}

glm::ivec3 toGridCell(const glm::ivec3& place, const BrickGrid& grid)
{
    const std::array<int, 3> cell = exchangeAxes(std::array{place.x, place.y, place.z}, grid);
    return {cell[0], cell[1], cell[2]};
}

osg::ref_ptr<const BrickModel> createModel(const LaidParts& parts, const BrickGrid& grid,
                                           const std::vector<PaletteColor>& colors, const std::vector<Brick>& covered)
{
    std::vector<Part> real;
    real.reserve(parts.size());
    for (const LaidPart& part : parts)
    {
        const PaletteColor& color = colors[part.color];
        real.push_back({exchangeAxes(part.place, grid), exchangeAxes(part.size, grid), color.color, color.code});
    }
    return BrickModel::createOfParts(grid, std::move(real), covered);
}

std::vector<std::uint32_t> findModelIndices(const LaidParts& parts, const BrickModel& model)
{
    std::vector<std::uint32_t> indices;
    indices.reserve(parts.size());
    for (const LaidPart& part : parts)
    {
        const glm::ivec3 place(part.place[0], part.place[1], part.place[2]);
        const Part* own = model.findPart(toGridCell(place, model.getGrid()));
        indices.push_back(static_cast<std::uint32_t>(own - model.getParts().data()));
    }
    return indices;
}

} // namespace osgLego
