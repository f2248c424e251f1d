#include <osgLego/model/SupportColumns.h>

#include <osgLego/data/CellKeys.h>
#include <osgLego/model/CellExposure.h>

#include <algorithm>
#include <array>
#include <utility>

#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

constexpr int BRICK_PLATES = 3; // the height of a brick in plates

/** Whether all columns of a size were made in a colour; bit 0 is the size 1x1, and bit 6 is 2x2. */
bool exists(const LayoutColor& color, int width)
{
    const unsigned int bit = width == 1 ? 0 : 6;
    return (color.bricks >> bit & 1u) != 0 && (color.plates >> bit & 1u) != 0;
}

void addCells(const LaidPart& part, std::vector<LayoutCell>& cells)
{
    for (int z = 0; z < part.size[2]; ++z)
        for (int y = 0; y < part.size[1]; ++y)
            for (int x = 0; x < part.size[0]; ++x)
                cells.push_back(
                    {{static_cast<std::uint16_t>(part.place[0] + x), static_cast<std::uint16_t>(part.place[1] + y),
                      static_cast<std::uint16_t>(part.place[2] + z)},
                     part.color});
}

} // namespace

LaidParts buildColumn(const SupportColumn& column, bool isOfPlates)
{
    const auto width = static_cast<std::uint8_t>(column.width);
    const int brickHeight = isOfPlates ? BRICK_PLATES : 1;
    LaidParts parts;
    for (int z = 0; z < column.height;)
    {
        const int height = column.height - z >= brickHeight ? brickHeight : 1;
        parts.push_back({{static_cast<std::uint16_t>(column.place.x), static_cast<std::uint16_t>(column.place.y),
                          static_cast<std::uint16_t>(column.place.z + z)},
                         {width, width, static_cast<std::uint8_t>(height)},
                         column.color});
        z += height;
    }
    return parts;
}

SupportedLayout addColumns(const SupportedLayout& layout, const std::vector<SupportColumn>& columns)
{
    SupportedLayout result = layout;
    for (const SupportColumn& column : columns)
    {
        const LaidParts parts = buildColumn(column, layout.problem.isOfPlates);
        for (const LaidPart& part : parts)
            addCells(part, result.problem.cells);
        result.parts.insert(result.parts.end(), parts.begin(), parts.end());
        result.numColumnParts += parts.size();
    }
    result.columns.insert(result.columns.end(), columns.begin(), columns.end());
    std::sort(result.parts.begin(), result.parts.end(), isPlacedBefore<LaidPart>);
    std::sort(result.problem.cells.begin(), result.problem.cells.end(), isPlacedBefore<LayoutCell>);
    return result;
}

SupportedLayout removeColumns(const SupportedLayout& layout, std::span<const SupportColumn> columns)
{
    SupportedLayout result = layout;
    const auto isRemoved = [columns](const auto& element)
    {
        const glm::ivec3 cell(element.place[0], element.place[1], element.place[2]);
        return std::any_of(columns.begin(), columns.end(),
                           [&cell](const SupportColumn& column) { return column.contains(cell); });
    };
    std::erase_if(result.problem.cells, isRemoved);
    result.numColumnParts -= std::erase_if(result.parts, isRemoved);
    std::erase_if(result.columns, [columns](const SupportColumn& column)
                  { return std::find(columns.begin(), columns.end(), column) != columns.end(); });
    return result;
}

double sumExposure(const SupportColumn& column, const CellExposure& exposure)
{
    double sum = 0.0;
    for (int z = 0; z < column.height; ++z)
        for (int y = 0; y < column.width; ++y)
            for (int x = 0; x < column.width; ++x)
                sum += exposure.get(column.place + glm::ivec3(x, y, z));
    return sum;
}

SupportColumns::SupportColumns(const LayoutProblem& problem, const LaidParts& parts) :
    _problem(problem), _parts(parts), _ground(problem.cells.empty() ? 0 : problem.cells.front().place[2])
{
    _covered.reserve(problem.cells.size());
    for (const LayoutCell& cell : problem.cells)
        _covered.insert(toCellKey({cell.place[0], cell.place[1], cell.place[2]}));
}

void SupportColumns::add(const SupportColumn& column)
{
    for (int z = 0; z < column.height; ++z)
        for (int y = 0; y < column.width; ++y)
            for (int x = 0; x < column.width; ++x)
                _covered.insert(toCellKey(column.place + glm::ivec3(x, y, z)));
}

bool SupportColumns::isFree(const glm::ivec3& cell) const
{
    return !_covered.contains(toCellKey(cell));
}

/** The column whose highest cell is `top`. @return a column of height 0 if the place isn't free. */
SupportColumn SupportColumns::makeColumn(const glm::ivec3& top, int width, std::uint16_t color) const
{
    const auto isLayerFree = [&](int z)
    {
        for (int y = 0; y < width; ++y)
            for (int x = 0; x < width; ++x)
                if (!isFree({top.x + x, top.y + y, z})) return false;
        return true;
    };
    const bool isInside =
        top.x >= 0 && top.y >= 0 && top.x + width <= _problem.size.x && top.y + width <= _problem.size.y;
    SupportColumn column{{top.x, top.y, top.z + 1}, width, 0, color};
    while (isInside && column.place.z > _ground && isLayerFree(column.place.z - 1))
    {
        --column.place.z;
        ++column.height;
    }
    return column;
}

/** A column of 2x2 cells that contains a column of one cell, if there is a place for one that is as high. */
SupportColumn SupportColumns::widen(const SupportColumn& column) const
{
    if (!exists(_problem.colors[column.color], 2)) return column;
    const int top = column.place.z + column.height - 1;
    for (const glm::ivec2& corner : std::array{glm::ivec2(0, 0), glm::ivec2(-1, 0), glm::ivec2(0, -1), glm::ivec2(-1)})
    {
        const SupportColumn wide =
            makeColumn({column.place.x + corner.x, column.place.y + corner.y, top}, 2, column.color);
        if (wide.height == column.height) return wide;
    }
    return column;
}

/** How much each column would be seen, in quarters of the mean exposure of its cells. */
std::vector<int> SupportColumns::getVisibilities(const std::vector<SupportColumn>& columns) const
{
    constexpr double STEPS = 4.0;
    const CellExposure exposure(_problem);
    std::vector<int> visibilities;
    visibilities.reserve(columns.size());
    for (const SupportColumn& column : columns)
    {
        const int numCells = column.width * column.width * column.height;
        visibilities.push_back(static_cast<int>(STEPS * sumExposure(column, exposure) / numCells));
    }
    return visibilities;
}

std::vector<SupportColumn> SupportColumns::find(const std::vector<std::uint32_t>& below) const
{
    std::vector<SupportColumn> places;
    glm::dvec2 middle(0.0);
    for (const std::uint32_t index : below)
    {
        const LaidPart& part = _parts[index];
        for (int y = 0; y < part.size[1]; ++y)
            for (int x = 0; x < part.size[0]; ++x)
            {
                const SupportColumn column =
                    makeColumn({part.place[0] + x, part.place[1] + y, part.place[2] - 1}, 1, part.color);
                if (column.height == 0) continue;
                places.push_back(column);
                middle += glm::dvec2(column.place.x, column.place.y);
            }
    }
    if (places.empty()) return {};
    middle /= static_cast<double>(places.size());
    const auto offsetOf = [&middle](const SupportColumn& column)
    { return glm::dvec2(column.place.x, column.place.y) - middle; };
    std::vector<SupportColumn> chosen;
    const auto choose = [&](const auto& isBefore)
    {
        const SupportColumn column = widen(*std::min_element(places.begin(), places.end(), isBefore));
        const bool isKnown = std::any_of(chosen.begin(), chosen.end(),
                                         [&column](const SupportColumn& other)
                                         { return other.place == column.place && other.width == column.width; });
        if (!isKnown) chosen.push_back(column);
    };
    const std::vector<int> visibilities = getVisibilities(places);
    const auto rankOf = [&](const SupportColumn& column) {
        return std::pair(visibilities[static_cast<std::size_t>(&column - places.data())],
                         glm::length(offsetOf(column)));
    };
    choose([&](const SupportColumn& column, const SupportColumn& other) { return rankOf(column) < rankOf(other); });
    choose([&](const SupportColumn& column, const SupportColumn& other)
           { return glm::length(offsetOf(column)) < glm::length(offsetOf(other)); });
    for (const glm::dvec2& direction : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1),
                                        glm::dvec2(1, 1), glm::dvec2(-1, 1), glm::dvec2(1, -1), glm::dvec2(-1, -1)})
        choose([&](const SupportColumn& column, const SupportColumn& other)
               { return glm::dot(offsetOf(column), direction) > glm::dot(offsetOf(other), direction); });
    return chosen;
}

} // namespace osgLego
