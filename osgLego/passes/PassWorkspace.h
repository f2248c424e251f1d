#pragma once

#include <osgLego/LegoStatistics.h>
#include <osgLego/data/BrickSet.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/passes/GridVertexArrays.h>
#include <osgLego/passes/Occupancy.h>
#include <osgLego/passes/PaletteTextures.h>
#include <osgLego/store/BrickStore.h>

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include <osg/GraphicsContext>
#include <osg/Referenced>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** Triangles of a source on the GPU, before and after subdivision. */
struct WorkingBatch
{
    const GridBatch* batch = nullptr;
    GlBuffer source;
    GlTexture lookup; //!< the source as a buffer texture
    GlBuffer parts;   //!< the source, cut down to the grid; empty if it does not reach beyond
    GlBuffer fine;    //!< the subdivided triangles; empty if no edge was too long
    GLsizei fineVertexBytes = sizeof(GridVertex); //!< the size of a vertex in `fine`
    GLsizei numFineTriangles = 0;

    GLuint getCoarseBuffer() const { return parts.get() != 0 ? parts.get() : source.get(); }
    /** Read the vertices of the fine triangles in the following draw calls. */
    void bindFine(const GridVertexArrays& arrays) const
    {
        if (fine.get() != 0)
            arrays.bind(fine.get(), fineVertexBytes);
        else
            arrays.bind(getCoarseBuffer());
    }
    /** Delete the buffers and the texture at once. Needs their context current. */
    void deleteNow(const osg::State& state)
    {
        fine.deleteNow(state);
        parts.deleteNow(state);
        lookup.deleteNow(state);
        source.deleteNow(state);
    }
};

/** A legolization in progress in one context, which each pass hands on to the next. */
struct Legolization
{
    osg::ref_ptr<const LegoSource> source;
    osg::ref_ptr<const BrickSet> bricks;
    const osg::GraphicsContext* owner = nullptr; //!< the context that does the work, of those that share GL objects
    unsigned int nextStep = 0;                   //!< the number of the next pass
    bool isComplete = false;
    std::vector<WorkingBatch> batches;
    Occupancy occupancy; //!< of the last slab voxelized
    GlBuffer buffer;     //!< of BrickPoint
    GlBuffer neighbors;  //!< of BrickNeighbors, of the same bricks; empty if they are not known
    std::size_t brickCapacity = 0;
    std::size_t numBricks = 0;
    std::vector<Brick> readBack;
    LegoStatistics statistics;
};

/** The work in progress of a node's passes in one context. */
struct PassContext : public osg::Referenced
{
    std::mutex mutex; //!< held for every use of `work`
    std::unique_ptr<Legolization> work;
};

/** The source that the passes are to legolize, and the set in which its bricks are delivered. Both are null if no
 * bricks are wanted. */
struct WantedBricks
{
    osg::ref_ptr<const LegoSource> source;
    osg::ref_ptr<const BrickSet> bricks;
};

/** The data that the passes of a node share: the wanted source, the work in progress in each context, the textures of
 * surfaces, and the store to which bricks are delivered.
 *
 * Every function may be called from any thread.
 */
class PassWorkspace : public osg::Referenced
{
public:
    explicit PassWorkspace(BrickStore& store) : _store(&store) {}

    BrickStore& getStore() const { return *_store; }

    /** Set the wanted source. @param bricks the set to deliver once its bricks are made. */
    void setSource(const LegoSource& source, const BrickSet& bricks);
    /** Withdraw the wanted source: passes that have not begun do nothing. */
    void clearSource();
    /** The wanted source and its brick set, read together. */
    WantedBricks getWanted() const;

    /** Find the neighbours of bricks from now on. */
    void wantNeighbors() { _areNeighborsWanted = true; }
    bool areNeighborsWanted() const { return _areNeighborsWanted; }

    /** The work of a context ID; initially none. */
    osg::ref_ptr<PassContext> getContext(unsigned int contextID) const;

    /** The texture of a surface, for any context; kept until releaseTextures() or setSource(). */
    osg::ref_ptr<osg::Texture2D> getTexture(const SurfaceTexture& surface) const;
    /** The textures of a lookup with a palette, for any context; kept until releaseTextures(), or until those of
     * another one are needed. */
    osg::ref_ptr<const PaletteTextures> getPaletteTextures(const PaletteLookup& lookup) const;
    /** Release the textures of surfaces and palettes, which are only needed to make bricks. */
    void releaseTextures() const;

    /** Release the GL objects of one context, or of all contexts if `state` is null. */
    void releaseGLObjects(osg::State* state) const;

private:
    ~PassWorkspace() override = default;

    osg::ref_ptr<BrickStore> _store;
    mutable std::mutex _mutex;
    WantedBricks _wanted;
    std::atomic<bool> _areNeighborsWanted{false};
    mutable std::map<unsigned int, osg::ref_ptr<PassContext>> _contexts;
    mutable std::map<const SurfaceTexture*, osg::ref_ptr<osg::Texture2D>> _textures;
    mutable osg::ref_ptr<const PaletteTextures> _paletteTextures;
};

} // namespace osgLego
