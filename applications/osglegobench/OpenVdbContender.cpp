#include "NativeContender.h"

#include <algorithm>
#include <cmath>

#include <openvdb/tools/MeshToVolume.h>

namespace osgLego
{

namespace
{

constexpr std::array<std::uint8_t, 3> GREY{160, 160, 160};

/** An adapter that passes triangles to OpenVDB without copying them. */
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
        // The centres of voxels have integer coordinates, those of cells half-integer ones.
        position = openvdb::Vec3d(place.x, place.y, place.z) - openvdb::Vec3d(0.5);
    }

private:
    std::vector<const GridBatch*> _batches;
    std::vector<std::size_t> _ends; // the number of triangles up to the end of each batch
};

/** The bricks of the cells near a mesh. Cells outside the grid are skipped; they can also be near the mesh. */
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

/** OpenVDB's meshToVolume, a distance field without colours: a cell is covered if its centre is at most half a cell
 * from the mesh. This leaves no tunnels, but misses cells that the mesh only grazes. */
class OpenVdbContender : public NativeContender
{
public:
    /** @param isNarrow use the cheapest mode of meshToVolume, unsigned distances up to one cell, instead of its
     * default, signed distances up to three cells. */
    explicit OpenVdbContender(bool isNarrow) : _isNarrow(isNarrow) {}

    std::string getName() const override { return _isNarrow ? "openvdb, narrow" : "openvdb"; }
    bool hasColors() const override { return false; }

protected:
    osg::ref_ptr<const BrickModel> findCells() override
    {
        const TriangleAdapter adapter(getTriangles());
        const openvdb::math::Transform transform;
        constexpr float BAND = 1.0f; // cells
        const openvdb::FloatGrid::Ptr distances =
            _isNarrow ? openvdb::tools::meshToVolume<openvdb::FloatGrid>(adapter, transform, BAND, BAND,
                                                                         openvdb::tools::UNSIGNED_DISTANCE_FIELD)
                      : openvdb::tools::meshToVolume<openvdb::FloatGrid>(adapter, transform);
        const BrickGrid& grid = getTriangles().getGrid();
        return BrickModel::create(grid, collectBricks(*distances, grid.dimensions));
    }

private:
    bool _isNarrow;
};

} // namespace

} // namespace osgLego

// The function that osglegobench looks up in this library.
extern "C" __attribute__((visibility("default"))) osgLego::Contender* createOpenVdbContender(bool isNarrow);

osgLego::Contender* createOpenVdbContender(bool isNarrow)
{
    return new osgLego::OpenVdbContender(isNarrow);
}
