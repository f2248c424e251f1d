#include "GltfBricks.h"

#include <algorithm>
#include <set>

namespace osgLego
{

namespace
{

std::vector<Part> getPartsOrCells(const BrickModel& model)
{
    if (!model.getParts().empty()) return model.getParts();
    std::vector<Part> cells;
    cells.reserve(model.getBricks().size());
    for (const Brick& brick : model.getBricks())
        cells.push_back({brick.cell, {1, 1, 1}, brick.color, Part::NO_CODE});
    return cells;
}

} // namespace

GltfBricks::GltfBricks(const BrickModel& model, std::size_t mostColors)
{
    const std::vector<Part> parts = getPartsOrCells(model);
    std::set<std::array<std::uint8_t, 3>> colors;
    for (const Part& part : parts)
        colors.insert(part.color);
    _numColors = colors.size();
    _hasColorsOfInstances = _numColors > mostColors;
    for (const Part& part : parts)
        add(part, model.getGrid());
}

glm::dvec3 GltfBricks::getCenter(const std::array<int, 3>& block)
{
    return glm::dvec3(BLOCK) * (glm::dvec3(block[0], block[1], block[2]) + 0.5);
}

void GltfBricks::add(const Part& part, const BrickGrid& grid)
{
    const int up = grid.getUpIndex();
    const int first = (up + 1) % 3;
    const int second = (up + 2) % 3;
    const glm::ivec3 size = part.getSize();
    Key key;
    for (std::size_t axis = 0; axis < 3; ++axis)
        key.block[axis] = part.cell[axis] / BLOCK;
    key.shape = {std::max(size[first], size[second]), std::min(size[first], size[second]), size[up]};
    key.isTurned = size[first] < size[second];
    if (!_hasColorsOfInstances) key.color = part.color;
    glm::dvec3 place = glm::dvec3(part.getCell()) + 0.5 * glm::dvec3(size) - getCenter(key.block);
    place[up] -= 0.5 * size[up];
    _groups[key].push_back({place, part.color});
}

} // namespace osgLego
