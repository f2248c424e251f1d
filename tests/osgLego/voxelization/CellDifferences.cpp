#include "CellDifferences.h"

#include <osgLego/cpu/TriangleOverlap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgLego::test
{

namespace
{

// Cells that a triangle overlaps or misses by less than this may differ: single precision can't decide them.
constexpr double MARGIN = 1e-4;

/** The depth to which the triangles enter a cell; negative if they miss it. */
double marginOf(const GridTriangles& triangles, const glm::ivec3& cell)
{
    double margin = -std::numeric_limits<double>::max();
    for (const GridBatch& batch : triangles.getBatches())
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
        {
            const TriangleOverlap overlap(batch.vertices[first].position, batch.vertices[first + 1].position,
                                          batch.vertices[first + 2].position);
            margin = std::max(margin, overlap.getMargin(cell));
        }
    return margin;
}

} // namespace

bool isColorOff(const Brick& a, const Brick& b)
{
    for (std::size_t channel = 0; channel < 3; ++channel)
        if (std::abs(a.color[channel] - b.color[channel]) > 2) return true;
    return false;
}

CellDifferences compare(const GridTriangles& triangles, const BrickModel& cpu, const BrickModel& gpu)
{
    CellDifferences differences;
    const auto count = [&](const BrickModel& from, const BrickModel& in, bool colors)
    {
        for (const Brick& brick : from.getBricks())
        {
            const glm::ivec3 cell(brick.cell[0], brick.cell[1], brick.cell[2]);
            if (const Brick* other = in.find(cell))
            {
                if (colors && isColorOff(brick, *other)) ++differences.offColor;
                continue;
            }
            ++(std::abs(marginOf(triangles, cell)) < MARGIN ? differences.within : differences.beyond);
        }
    };
    count(cpu, gpu, true);
    count(gpu, cpu, false);
    return differences;
}

} // namespace osgLego::test
