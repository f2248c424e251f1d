#include "VoxelTruth.h"

#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/cpu/TriangleOverlap.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace osgLego
{

namespace
{

using Corners = std::array<glm::dvec3, 3>;

/** Twice the signed area of the triangle formed by two points of a plane and its origin. Corners are single-precision
 * numbers and centres half-integers, so that this is exact except for corners with digits below a millionth of a cell.
 */
double areaOf(double u1, double v1, double u2, double v2)
{
    return u1 * v2 - u2 * v1;
}

/** Whether a triangle crosses the segment from a cell's centre to the centre of the next cell along an axis. */
bool crosses(const Corners& corners, const glm::ivec3& cell, int axis)
{
    const int axisU = (axis + 1) % 3;
    const int axisV = (axis + 2) % 3;
    const glm::dvec3 start = glm::dvec3(cell) + 0.5;
    std::array<double, 3> u{};
    std::array<double, 3> v{};
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
        u[corner] = corners[corner][axisU] - start[axisU];
        v[corner] = corners[corner][axisV] - start[axisV];
    }
    const std::array<double, 3> areas{areaOf(u[1], v[1], u[2], v[2]), areaOf(u[2], v[2], u[0], v[0]),
                                      areaOf(u[0], v[0], u[1], v[1])};
    const auto [least, most] = std::minmax_element(areas.begin(), areas.end());
    const double sum = areas[0] + areas[1] + areas[2];
    if ((*least < 0.0 && *most > 0.0) || sum == 0.0) return false;
    double depth = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner)
        depth += areas[corner] * (corners[corner][axis] - start[axis]);
    depth /= sum;
    return depth >= 0.0 && depth < 1.0;
}

/** A segment, given by its lower cell and its axis; the cell may be one below the grid. */
std::uint64_t numberOf(const glm::ivec3& cell, int axis)
{
    constexpr unsigned int BITS = 20;
    std::uint64_t number = static_cast<std::uint64_t>(axis);
    for (int index = 0; index < 3; ++index)
        number = number << BITS | static_cast<std::uint64_t>(cell[index] + 1);
    return number;
}

/** Record the segments to and from an empty cell that a triangle crosses. */
void collect(const Corners& corners, const glm::ivec3& cell, const CellSet& covered,
             std::vector<std::uint64_t>& segments)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        glm::ivec3 step(0);
        step[axis] = 1;
        if (!covered.contains(cell + step) && crosses(corners, cell, axis)) segments.push_back(numberOf(cell, axis));
        const glm::ivec3 below = cell - step;
        if (!covered.contains(below) && crosses(corners, below, axis)) segments.push_back(numberOf(below, axis));
    }
}

/** Call a function with each triangle's corners and the cells that the triangle overlaps. */
template <typename Function>
void visitTriangles(const GridTriangles& triangles, const Function& function)
{
    std::vector<glm::ivec3> cells;
    for (const GridBatch& batch : triangles.getBatches())
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
        {
            const GridVertex* vertices = &batch.vertices[first];
            const Corners corners{vertices[0].position, vertices[1].position, vertices[2].position};
            cells.clear();
            TriangleOverlap(corners[0], corners[1], corners[2]).findCells(triangles.getGrid().dimensions, cells);
            function(corners, cells);
        }
}

double ratio(std::size_t part, std::size_t whole)
{
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

VoxelTruth::VoxelTruth(const GridTriangles& triangles) :
    _triangles(&triangles), _reference(voxelizeOnCpu(triangles)), _cells(triangles.getGrid().dimensions)
{
    visitTriangles(triangles,
                   [this](const Corners&, const std::vector<glm::ivec3>& cells)
                   {
                       for (const glm::ivec3& cell : cells)
                           _cells.insert(cell);
                   });
}

VoxelQuality VoxelTruth::compare(const BrickModel& found, bool hasColors) const
{
    CellSet cells(_cells.getDimensions());
    std::size_t numRight = 0;
    std::size_t numOutside = 0; // outside the grid; always wrong
    for (const Brick& brick : found.getBricks())
        if (!cells.isInside(brick.getCell()))
            ++numOutside;
        else if (cells.insert(brick.getCell()) && _cells.contains(brick.getCell()))
            ++numRight;
    VoxelQuality quality;
    quality.numCells = cells.getSize() + numOutside;
    quality.precision = ratio(numRight, quality.numCells);
    quality.recall = ratio(numRight, _cells.getSize());
    quality.numTunnels = countTunnels(cells);
    if (hasColors) quality.colorError = computeColorError(found);
    return quality;
}

std::size_t VoxelTruth::countTunnels(const CellSet& covered) const
{
    std::vector<std::uint64_t> segments;
    // A triangle that crosses a segment overlaps the cell at one end or at the other.
    visitTriangles(*_triangles,
                   [&](const Corners& corners, const std::vector<glm::ivec3>& cells)
                   {
                       for (const glm::ivec3& cell : cells)
                           if (!covered.contains(cell)) collect(corners, cell, covered, segments);
                   });
    std::sort(segments.begin(), segments.end());
    return static_cast<std::size_t>(std::unique(segments.begin(), segments.end()) - segments.begin());
}

double VoxelTruth::computeColorError(const BrickModel& found) const
{
    std::size_t sum = 0;
    std::size_t numChannels = 0;
    for (const Brick& brick : found.getBricks())
    {
        const Brick* reference = _reference->find(brick.getCell());
        if (!reference) continue;
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum += static_cast<std::size_t>(std::abs(brick.color[channel] - reference->color[channel]));
        numChannels += 3;
    }
    return ratio(sum, numChannels);
}

} // namespace osgLego
