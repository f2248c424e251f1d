#include <osgLego/cpu/CpuVoxelizer.h>

#include <osgLego/cpu/RowBundle.h>
#include <osgLego/cpu/TriangleBins.h>
#include <osgLego/cpu/TriangleColor.h>
#include <osgLego/cpu/TriangleOverlap.h>
#include <osgLego/cpu/TriangleSlicer.h>
#include <osgLego/data/PassConstants.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace osgLego
{

namespace
{

/** The order in which TriangleSlicer appends parts. */
bool isBefore(const glm::ivec3& a, const glm::ivec3& b)
{
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
}

/** Voxelizes bundles of rows, one after the other. One thread. */
class BundleVoxelizer
{
public:
    BundleVoxelizer(const GridTriangles& triangles, const TriangleBins& bins, CellColor color,
                    const PreviousCells* previous) :
        _triangles(triangles),
        _bins(bins), _color(color), _previous(previous), _sums(triangles.getGrid().dimensions.x)
    {
    }

    RowBundle voxelize(std::size_t bundle)
    {
        const int number = static_cast<int>(bundle);
        const glm::ivec2 first = RowBundle::SIDE * glm::ivec2(number % _bins.getSize().x, number / _bins.getSize().x);
        const glm::ivec3& dimensions = _triangles.getGrid().dimensions;
        const glm::ivec3 begin(0, first.x, first.y);
        const glm::ivec3 end = glm::min(begin + glm::ivec3(dimensions.x, RowBundle::SIDE, RowBundle::SIDE), dimensions);
        _minimum = _triangles.getFirstCell() + begin;
        _maximum = _triangles.getFirstCell() + end - 1;

        auto batch = _triangles.getBatches().begin();
        std::size_t batchBegin = 0;
        for (const std::uint32_t triangle : _bins.getTriangles(bundle))
        {
            while (triangle - batchBegin >= batch->getNumTriangles())
                batchBegin += batch++->getNumTriangles();
            add(*batch, &batch->vertices[3 * (triangle - batchBegin)]);
        }
        return _sums.take(first, _previous);
    }

private:
    void add(const GridBatch& batch, const GridVertex* corners)
    {
        _parts.clear();
        const TriangleSlicer slicer(corners[0].position, corners[1].position, corners[2].position);
        if (!slicer.slice(_minimum, _maximum, _parts)) decideParts(corners);
        if (_parts.empty()) return;
        _colors.resize(std::max(_colors.size(), _parts.size()));
        const TriangleColor triangleColor(batch, corners);
        triangleColor.getColors(_parts, _colors.data());
        auto color = _colors.begin();
        for (const CellPart& part : _parts)
            _sums.add(part.cell - _triangles.getFirstCell(),
                      static_cast<float>(part.area + PassConstants::LEAST_WEIGHT), *color++);
        if (_color == CellColor::DOMINANT) addCandidates(triangleColor);
    }

    /** Add the colours of the parts, from which one is chosen for each cell. */
    void addCandidates(const TriangleColor& triangleColor)
    {
        if (triangleColor.hasMixtures()) triangleColor.makePlain(_parts, _colors.data());
        auto color = _colors.begin();
        for (const CellPart& part : _parts)
            _sums.addCandidate(part.cell - _triangles.getFirstCell(), *color++);
    }

    /** Replace the parts by those whose cells pass the overlap test. */
    void decideParts(const GridVertex* corners)
    {
        const TriangleOverlap overlap(corners[0].position, corners[1].position, corners[2].position);
        _cells.clear();
        overlap.findCells(_minimum, _maximum, _cells);
        std::sort(_cells.begin(), _cells.end(), isBefore);
        _decided.clear();
        auto part = _parts.begin();
        for (const glm::ivec3& cell : _cells)
        {
            while (part != _parts.end() && isBefore(part->cell, cell))
                ++part;
            _decided.push_back({cell, part != _parts.end() && part->cell == cell ? part->area : 0.0});
        }
        std::swap(_parts, _decided);
    }

    const GridTriangles& _triangles;
    const TriangleBins& _bins;
    CellColor _color;
    const PreviousCells* _previous;
    RowBundleSums _sums;
    // The cells of the bundle, and of the parts, are those of the positions.
    glm::ivec3 _minimum{0};
    glm::ivec3 _maximum{0};
    std::vector<CellPart> _parts;
    std::vector<CellPart> _decided;
    std::vector<glm::ivec3> _cells;
    std::vector<glm::vec3> _colors; // of the parts
};

osg::ref_ptr<const BrickModel> voxelizeInTasks(const GridTriangles& triangles, CellColor color,
                                               const PreviousCells* previous)
{
    const TriangleBins bins(triangles);
    std::vector<RowBundle> bundles(bins.getNumBundles());
    oneapi::tbb::enumerable_thread_specific<BundleVoxelizer> voxelizers(
        [&] { return BundleVoxelizer(triangles, bins, color, previous); });
    oneapi::tbb::parallel_for(std::size_t(0), bundles.size(),
                              [&](std::size_t bundle)
                              {
                                  if (!bins.getTriangles(bundle).empty())
                                      bundles[bundle] = voxelizers.local().voxelize(bundle);
                              });
    const BrickGrid& grid = triangles.getGrid();
    return BrickModel::createComplete(grid, joinBundles(bundles, grid.dimensions));
}

} // namespace

osg::ref_ptr<const BrickModel> voxelizeOnCpu(const GridTriangles& triangles, CellColor color,
                                             const PreviousCells* previous)
{
    // Isolated: while it waits here, the thread must not run tasks of the caller, which may need locks that it holds.
    return oneapi::tbb::this_task_arena::isolate([&] { return voxelizeInTasks(triangles, color, previous); });
}

} // namespace osgLego
