#include <osgLego/data/VoxelGrid.h>

#include <osgLego/GridLimits.h>

#include <algorithm>

#include <glm/common.hpp>

namespace osgLego
{

double VoxelGrid::getLongestSide(const BrickGrid& grid)
{
    const glm::dvec3 sides = glm::dvec3(grid.dimensions) * grid.cellSize / grid.getPitch();
    return std::max({sides.x, sides.y, sides.z});
}

VoxelGrid::VoxelGrid(const BrickGrid& grid, double width, double reach)
{
    const glm::dvec3 cell = grid.cellSize / grid.getPitch();
    _cellsPerVoxel = glm::ivec3(glm::clamp(glm::round(width / cell), 1.0, double(GridLimits::MOST_LAYERS)));
    _extent = glm::dvec3(_cellsPerVoxel) * cell;
    _size = (grid.dimensions + _cellsPerVoxel - 1) / _cellsPerVoxel + 2 * BORDER;
    _margin = glm::ivec3(glm::ceil(reach / _extent)) + 1;
    const glm::ivec3 all = _size + 2 * _margin;
    _strides = {1, all.x, static_cast<std::ptrdiff_t>(all.x) * all.y};
    _numVoxels = static_cast<std::size_t>(_strides.z) * static_cast<std::size_t>(all.z);
}

void VoxelGrid::cover(std::span<const BrickPoint> points)
{
    _covered.assign(_numVoxels, 0);
    const glm::ivec3& cells = _cellsPerVoxel;
    const auto placeOf = [&](const BrickPoint& point)
    { return getPlace(unpackBrick(point).getCell() / cells + BORDER); };
    // A surface through the middle of a voxel has as many bricks as the largest side of the voxel has cells.
    const int side = std::max({cells.x * cells.y, cells.y * cells.z, cells.z * cells.x});
    if (side == 1)
    {
        for (const BrickPoint& point : points)
            _covered[placeOf(point)] = 1;
        return;
    }
    std::vector<std::uint32_t> counts(_numVoxels, 0);
    for (const BrickPoint& point : points)
        ++counts[placeOf(point)];
    std::transform(counts.begin(), counts.end(), _covered.begin(),
                   [side](std::uint32_t count) { return 2 * count >= static_cast<std::uint32_t>(side) ? 1 : 0; });
}

} // namespace osgLego
