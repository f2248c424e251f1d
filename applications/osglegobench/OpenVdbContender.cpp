#include "OpenVdbContender.h"

#include <algorithm>
#include <cmath>

#include <openvdb/tools/MeshToVolume.h>
#include <osg/Timer>
#include <tbb/global_control.h>

namespace osgLego
{

namespace
{

constexpr std::size_t NUM_THREADS = 2;
constexpr std::array<std::uint8_t, 3> GREY{160, 160, 160};

/** Triangles as OpenVDB asks for them, so that nothing has to be copied. */
class TriangleAdapter
{
public:
    explicit TriangleAdapter(const GridTriangles& triangles)
    {
        for (const GridBatch& batch : triangles.getBatches())
        {
            _batches.push_back(&batch);
            _ends.push_back((_ends.empty() ? 0 : _ends.back()) + batch.getNumTriangles());
        }
    }

    std::size_t polygonCount() const { return _ends.back(); }
    std::size_t pointCount() const { return 3 * polygonCount(); }
    std::size_t vertexCount(std::size_t) const { return 3; }

    void getIndexSpacePoint(std::size_t triangle, std::size_t corner, openvdb::Vec3d& position) const
    {
        const auto end = std::upper_bound(_ends.begin(), _ends.end(), triangle);
        const GridBatch& batch = *_batches[static_cast<std::size_t>(end - _ends.begin())];
        const std::size_t first = *end - batch.getNumTriangles();
        const glm::vec3& place = batch.vertices[3 * (triangle - first) + corner].position;
        // A voxel's centre has whole numbers for coordinates, a cell's centre halves.
        position = openvdb::Vec3d(place.x, place.y, place.z) - openvdb::Vec3d(0.5);
    }

private:
    std::vector<const GridBatch*> _batches;
    std::vector<std::size_t> _ends; // the number of triangles up to the end of each batch
};

/** Cells beside the grid may be as near to a mesh on its bounds as those within. */
std::vector<Brick> collectBricks(const openvdb::FloatGrid& distances, const glm::ivec3& dimensions)
{
    constexpr float HALF_A_CELL = 0.5f;
    const openvdb::CoordBBox inside(openvdb::Coord(0),
                                    openvdb::Coord(dimensions.x - 1, dimensions.y - 1, dimensions.z - 1));
    std::vector<Brick> bricks;
    for (auto value = distances.cbeginValueOn(); value; ++value)
    {
        if (std::abs(*value) > HALF_A_CELL) continue;
        const openvdb::Coord cell = value.getCoord();
        if (!inside.isInside(cell)) continue;
        bricks.push_back({{static_cast<std::uint16_t>(cell.x()), static_cast<std::uint16_t>(cell.y()),
                           static_cast<std::uint16_t>(cell.z())},
                          GREY,
                          0});
    }
    return bricks;
}

} // namespace

std::string OpenVdbContender::prepare(const BenchMesh& mesh, osg::GraphicsContext& context)
{
    _triangles = mesh.triangles;
    _buffer.prepare(context);
    return {};
}

double OpenVdbContender::run()
{
    _bricks = nullptr;
    const osg::Timer& timer = *osg::Timer::instance();
    const osg::Timer_t start = timer.tick();
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, NUM_THREADS);
    const TriangleAdapter adapter(*_triangles);
    const openvdb::math::Transform transform;
    constexpr float BAND = 1.0f; // cells
    const openvdb::FloatGrid::Ptr distances =
        _field == Field::USUAL ? openvdb::tools::meshToVolume<openvdb::FloatGrid>(adapter, transform)
                               : openvdb::tools::meshToVolume<openvdb::FloatGrid>(
                                     adapter, transform, BAND, BAND, openvdb::tools::UNSIGNED_DISTANCE_FIELD);
    const BrickGrid& grid = _triangles->getGrid();
    _bricks = BrickModel::create(grid, collectBricks(*distances, grid.dimensions));
    _buffer.upload(createBrickPoints(*_bricks).points);
    return timer.delta_m(start, timer.tick());
}

void OpenVdbContender::release()
{
    _buffer.release();
    _bricks = nullptr;
    _triangles = nullptr;
}

} // namespace osgLego

// What osglegobench asks this library for, by name.
extern "C" __attribute__((visibility("default"))) osgLego::Contender* createOpenVdbContender(bool isNarrow);

osgLego::Contender* createOpenVdbContender(bool isNarrow)
{
    using Field = osgLego::OpenVdbContender::Field;
    return new osgLego::OpenVdbContender(isNarrow ? Field::NARROW : Field::USUAL);
}
