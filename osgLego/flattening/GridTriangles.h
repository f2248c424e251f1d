#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/PassConstants.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>
#include <glm/packing.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** A corner of a triangle in a grid: 32 bytes, in the vertex layout of the passes' shaders.
 *
 * `colorAndLevel` packs four 16-bit fractions: red and green in the first word, blue and the texture level, between
 * PassConstants::MINIMUM_LEVEL and MAXIMUM_LEVEL, in the second. At this mipmap level, a cell on the triangle is two
 * texels wide, so that linear filtering covers one cell; it is negative where a cell is less than two texels wide. It
 * is the same for all three corners.
 */
struct GridVertex
{
    glm::vec3 position{0.0f};   //!< in cell units, at least 0; see GridTriangles::getFirstCell()
    std::uint32_t triangle = 0; //!< the index of the source triangle in its batch
    glm::vec2 coordinate{0.0f};
    std::array<std::uint32_t, 2> colorAndLevel{};

    glm::vec3 getColor() const
    {
        const glm::vec2 redGreen = glm::unpackUnorm2x16(colorAndLevel[0]);
        return {redGreen.x, redGreen.y, glm::unpackUnorm2x16(colorAndLevel[1]).x};
    }
    double getLevel() const
    {
        return glm::mix(PassConstants::MINIMUM_LEVEL, PassConstants::MAXIMUM_LEVEL,
                        static_cast<double>(glm::unpackUnorm2x16(colorAndLevel[1]).y));
    }
    /** @param level is clamped to what a fraction can denote. */
    void setColorAndLevel(const glm::vec3& color, double level)
    {
        constexpr double RANGE = PassConstants::MAXIMUM_LEVEL - PassConstants::MINIMUM_LEVEL;
        const auto fraction = static_cast<float>((level - PassConstants::MINIMUM_LEVEL) / RANGE);
        colorAndLevel = {glm::packUnorm2x16({color.r, color.g}), glm::packUnorm2x16({color.b, fraction})};
    }
};
static_assert(sizeof(GridVertex) == 32, "the vertex layout of the shaders");

/** The vertex halfway between two corners of a triangle, and the square of their distance in cells, rounded as in
 * shaders/subdivision/subdivision.geom. */
GridVertex midpoint(const GridVertex& a, const GridVertex& b);
float squaredLength(const GridVertex& a, const GridVertex& b);

/** At most MAXIMUM_TRIANGLES triangles in a grid, three vertices each, that share one texture. */
struct GridBatch
{
    // The passes look source triangles up in a buffer texture, whose size GL limits.
    static constexpr std::size_t MAXIMUM_TRIANGLES = std::size_t(1) << 20;

    osg::ref_ptr<const SurfaceTexture> texture;
    TextureEnvironment environment = TextureEnvironment::MODULATE;
    std::vector<GridVertex> vertices;
    float longestEdge = 0.0f; //!< in cells

    /** Whether the bits of all values are equal, and the texture is the same object. */
    bool isEqualTo(const GridBatch& other) const;
    std::size_t getNumTriangles() const { return vertices.size() / 3; }
    /** An estimate of the number of triangles after subdivision to edges of at most `edgeLimit` cells. */
    std::size_t estimateFineTriangles(double edgeLimit) const;
};

/** A mesh in the grid of its bricks: the input of every voxelization method, on the GPU and on the CPU.
 *
 * Positions are rounded to single precision once, here, so that all methods see exactly the same triangles; GridFrame
 * describes their coordinates. Triangles that can't reach into the grid are omitted.
 *
 * Uses no GL. Immutable once created; every function may be called from any thread.
 */
class GridTriangles : public osg::Referenced
{
public:
    static osg::ref_ptr<const GridTriangles> create(const SceneTriangles& triangles, const LegoSettings& settings);

    /** Triangles in use that are equal to others, such as those of another copy of a file; the others if there are
     * none.
     */
    static osg::ref_ptr<const GridTriangles> share(const GridTriangles& triangles);

    const BrickGrid& getGrid() const { return _grid; }
    /** A position in cell (x, y, z) of the grid is in the unit cube at (x, y, z) plus this: (0, 0, 0) if the grid is
     * fitted to the mesh. Coordinates may be negative, and positions outside the grid. */
    const glm::ivec3& getFirstCell() const { return _firstCell; }
    const std::vector<GridBatch>& getBatches() const { return _batches; }
    std::size_t getNumTriangles() const;
    float getLongestEdge() const;
    /** An estimate of the number of cells that the triangles cover, more likely too high than too low, and at most the
     * number of cells in the grid. */
    std::size_t estimateCoveredCells() const;

private:
    GridTriangles() = default;
    ~GridTriangles() override = default;

    bool isEqualTo(const GridTriangles& other) const;
    std::uint64_t computeHash() const;

    BrickGrid _grid;
    glm::ivec3 _firstCell{0};
    std::vector<GridBatch> _batches;
};

} // namespace osgLego
