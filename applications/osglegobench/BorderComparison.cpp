#include "BorderComparison.h"

#include "Spread.h"

#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/cpu/DominantColors.h>

#include <set>
#include <utility>
#include <vector>

#include <osg/Timer>

namespace osgLego
{

namespace
{

JsonValue describeCells(const Palette& palette, const GridTriangles& triangles, CellColor cellColor,
                        unsigned int numRuns)
{
    osg::ref_ptr<const BrickModel> cells;
    std::vector<double> times;
    for (unsigned int run = 0; run < numRuns; ++run)
    {
        const osg::Timer_t start = osg::Timer::instance()->tick();
        cells = voxelizeOnCpu(triangles, cellColor);
        times.push_back(osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick()));
    }
    std::set<std::size_t> colors;
    std::size_t numPairs = 0;
    std::size_t numDifferent = 0;
    for (const Brick& brick : cells->getBricks())
    {
        const std::size_t color = palette.findNearest(brick.color);
        colors.insert(color);
        for (int axis = 0; axis < 3; ++axis)
        {
            glm::ivec3 neighbour = brick.getCell();
            ++neighbour[axis];
            const Brick* other = cells->find(neighbour);
            if (!other) continue;
            ++numPairs;
            numDifferent += palette.findNearest(other->color) == color ? 0 : 1;
        }
    }
    return {{"colors", colors.size()},
            {"different", numPairs == 0 ? 0.0 : static_cast<double>(numDifferent) / static_cast<double>(numPairs)},
            {"milliseconds", createSpread(std::move(times))}};
}

} // namespace

JsonValue compareBorders(const Palette& palette, const GridTriangles& triangles, unsigned int numRuns,
                         const std::string& name)
{
    return {{"mesh", name},
            {"mean", describeCells(palette, triangles, CellColor::MEAN, numRuns)},
            {"dominant", describeCells(palette, triangles, CellColor::DOMINANT, numRuns)}};
}

} // namespace osgLego
