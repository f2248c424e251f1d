#include "VoxelTruth.h"

#include "TunnelCounter.h"

#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/cpu/TriangleOverlap.h>

#include <cstdlib>

namespace osgLego
{

namespace
{

void insertCells(const GridTriangles& triangles, CellSet& set)
{
    std::vector<glm::ivec3> cells;
    for (const GridBatch& batch : triangles.getBatches())
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
        {
            const GridVertex* corners = &batch.vertices[first];
            cells.clear();
            TriangleOverlap(corners[0].position, corners[1].position, corners[2].position)
                .findCells(set.getDimensions(), cells);
            for (const glm::ivec3& cell : cells)
                set.insert(cell);
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
    insertCells(triangles, _cells);
}

VoxelQuality VoxelTruth::compare(const BrickModel& found, bool hasColors) const
{
    CellSet cells(_cells.getDimensions());
    std::size_t numRight = 0;
    std::size_t numOutside = 0; // of the grid: as wrong as can be
    for (const Brick& brick : found.getBricks())
        if (!cells.isInside(brick.getCell()))
            ++numOutside;
        else if (cells.insert(brick.getCell()) && _cells.contains(brick.getCell()))
            ++numRight;
    VoxelQuality quality;
    quality.numCells = cells.getSize() + numOutside;
    quality.precision = ratio(numRight, quality.numCells);
    quality.recall = ratio(numRight, _cells.getSize());
    quality.numTunnels = countTunnels(*_triangles, cells);
    if (hasColors) quality.colorError = computeColorError(found);
    return quality;
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
