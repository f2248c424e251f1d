#include "BasePlate.h"

#include <osgLego/polygonization/FadedColor.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

struct PlateSize
{
    int width; // studs, the shorter side
    int length;
    const char* number;
};

// From small to large, those that are or were made in green.
constexpr std::array<PlateSize, 6> SIZES{
    {{8, 16, "3865"}, {16, 16, "3867"}, {16, 24, "3334"}, {16, 32, "3857"}, {32, 32, "3811"}, {48, 48, "4186"}}};

constexpr std::array<std::uint8_t, 3> GREEN{0x23, 0x78, 0x41};
constexpr std::int32_t GREEN_BRICKLINK = 6; // BrickLink
constexpr double THICKNESS = 0.2;           // pitches

/** As earlier parts are drawn. */
std::array<std::uint8_t, 3> fade(const std::array<std::uint8_t, 3>& color)
{
    constexpr std::array<double, 3> FADED{FadedColor::FADED_RED, FadedColor::FADED_GREEN, FadedColor::FADED_BLUE};
    std::array<std::uint8_t, 3> faded{};
    for (std::size_t channel = 0; channel < faded.size(); ++channel)
        faded[channel] = static_cast<std::uint8_t>(
            std::lround((1.0 - FadedColor::FADING) * color[channel] + FadedColor::FADING * 255.0 * FADED[channel]));
    return faded;
}

} // namespace

BasePlate::BasePlate(const BrickModel& model) : _grid(model.getGrid())
{
    glm::ivec3 lowest(_grid.dimensions);
    glm::ivec3 end(0);
    for (const Part& part : model.getParts())
    {
        lowest = glm::min(lowest, part.getCell());
        end = glm::max(end, part.getCell() + part.getSize());
    }
    const int up = _grid.getUpIndex();
    const glm::ivec2 footprint(end.x - lowest.x, end[3 - up] - lowest[3 - up]);
    choose(footprint);
    const glm::ivec2 studs = getSize();
    const glm::ivec2 before = (studs - footprint) / 2;
    // With y upwards, z points to the front.
    _margin = {before.x, up == 1 ? studs.y - footprint.y - before.y : before.y};
    const double thickness = THICKNESS * _grid.getPitch();
    glm::dvec3 corner(lowest);
    corner.x -= before.x;
    corner[3 - up] -= before.y;
    _grid.origin += corner * _grid.cellSize;
    _grid.origin[up] -= thickness;
    _grid.cellSize[up] = thickness;
    _grid.dimensions = {studs.x, studs.y, studs.y};
    _grid.dimensions[up] = 1;
}

void BasePlate::choose(const glm::ivec2& footprint)
{
    const bool isDeep = footprint.y > footprint.x;
    std::pair best(std::numeric_limits<int>::max(), 0); // the number of plates and their studs
    for (const PlateSize& plate : SIZES)
    {
        const glm::ivec2 size = isDeep ? glm::ivec2(plate.width, plate.length) : glm::ivec2(plate.length, plate.width);
        const glm::ivec2 counts = (footprint + size - 1) / size;
        const int count = counts.x * counts.y;
        const std::pair own(count, count * size.x * size.y);
        if (own >= best) continue;
        best = own;
        _number = plate.number;
        _size = size;
        _counts = counts;
    }
}

bool BasePlate::isNumber(std::string_view number)
{
    return std::any_of(SIZES.begin(), SIZES.end(), [number](const PlateSize& plate) { return number == plate.number; });
}

std::string BasePlate::getName(const std::string& sign) const
{
    return "Base plate " + std::to_string(std::min(_size.x, _size.y)) + sign +
           std::to_string(std::max(_size.x, _size.y));
}

std::size_t BasePlate::getQuantity() const
{
    return static_cast<std::size_t>(_counts.x) * static_cast<std::size_t>(_counts.y);
}

PartsList::Extra BasePlate::createRow() const
{
    PartsList::Extra row;
    row.number = _number;
    row.name = getName();
    row.color.code = COLOR_CODE;
    row.color.name = "Green";
    row.color.brickLink = GREEN_BRICKLINK;
    row.quantity = getQuantity();
    return row;
}

osg::ref_ptr<const BrickModel> BasePlate::createModel(bool isFaded) const
{
    const int up = _grid.getUpIndex();
    std::vector<Part> parts;
    for (int row = 0; row < _counts.y; ++row)
        for (int column = 0; column < _counts.x; ++column)
        {
            Part& part = parts.emplace_back();
            part.cell[0] = static_cast<std::uint16_t>(column * _size.x);
            part.cell[static_cast<std::size_t>(3 - up)] = static_cast<std::uint16_t>(row * _size.y);
            part.size[0] = static_cast<std::uint8_t>(_size.x);
            part.size[static_cast<std::size_t>(3 - up)] = static_cast<std::uint8_t>(_size.y);
            part.size[static_cast<std::size_t>(up)] = 1;
            part.color = isFaded ? fade(GREEN) : GREEN;
            part.colorCode = COLOR_CODE;
        }
    return BrickModel::createOfParts(_grid, std::move(parts));
}

} // namespace osgLego
