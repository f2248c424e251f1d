#pragma once

#include "GlContender.h"
#include "GlRestoration.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <osg/Program>

namespace osgLego
{

/** Rasterization along each triangle's dominant axis: Crassin, Green, "Octree-Based Sparse Voxelization Using the GPU
 * Hardware Rasterizer", 2012, up to the list of voxels from which an octree would be built.
 *
 * A geometry shader projects every triangle along the axis on which it covers most pixels. Fragments write the running
 * mean of colours (compare and swap) to a texture of the grid's size, and the first fragment in a cell appends the cell
 * to a list. A compute shader creates the points of visible bricks from this list: only counters are read back.
 *
 * The thin variant uses the cell at each pixel's centre, so that walls have holes where they are between centres. The
 * conservative variant enlarges triangles by half a pixel (Hasselgren, Akenine-Moller, Ohlsson, "Conservative
 * Rasterization", 2005), within their bounds, and uses all cells of a pixel that the triangle's plane intersects. It
 * finds too many cells, since neither the outline nor the plane is tested against the cell itself, and misses some
 * along triangles that are too thin for an accurate plane.
 */
class DominantAxisContender : public GlContender
{
public:
    enum class Coverage
    {
        THIN,
        CONSERVATIVE
    };

    explicit DominantAxisContender(Coverage coverage = Coverage::THIN) : _coverage(coverage) {}

    std::string getName() const override
    {
        return _coverage == Coverage::THIN ? "dominant axis" : "dominant axis, conservative";
    }
    bool hasColors() const override { return true; }

protected:
    std::string createObjects(osg::State& state) override;
    void findBricks(osg::State& state) override;
    osg::ref_ptr<const BrickModel> readBricks(osg::State& state) override;
    void releaseObjects() override;

private:
    using ClearTexture = void(GL_APIENTRY*)(GLuint texture, GLint level, GLenum format, GLenum type, const void* data);
    using Counters = std::vector<std::uint32_t>; // cells, points

    std::string createPrograms(osg::State& state);
    std::string createVolume(osg::State& state);
    void reserve(const osg::State& state, std::size_t numCells);
    void bind(const osg::State& state) const;
    void unbind(const osg::State& state) const;
    void setCounters(const osg::State& state, const Counters& counters) const;
    Counters readCounters(const osg::State& state) const;
    void drawCells(osg::State& state) const;
    void extract(osg::State& state, std::uint32_t numCells, bool takesHidden) const;

    Coverage _coverage;
    std::size_t _capacity = 0; // cells
    std::uint32_t _numCells = 0;
    ClearTexture _clearTexture = nullptr;
    GlTexture _volume;
    GlFramebuffer _framebuffer;
    GlBuffer _counters;
    GlBuffer _cells;
    GlBuffer _points;
    osg::ref_ptr<osg::Program> _drawing;
    osg::ref_ptr<osg::Program> _extraction;
};

} // namespace osgLego
