#pragma once

#include <osgLego/LegoStatistics.h>
#include <osgLego/data/BrickSet.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/passes/Occupancy.h>
#include <osgLego/store/BrickStore.h>

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

/** Triangles of a source on the GPU, as they came and as subdivision left them. */
struct WorkingBatch
{
    const GridBatch* batch = nullptr;
    GlBuffer source;
    GlTexture lookup; //!< the source as a buffer texture
    GlBuffer fine;    //!< empty: no edge was too long, and the source is fine as it is
    GLsizei numFineTriangles = 0;

    GLuint getFineBuffer() const { return fine.get() != 0 ? fine.get() : source.get(); }
};

/** A legolization under way in one context: what one pass leaves to the next. */
struct Legolization
{
    osg::ref_ptr<const LegoSource> source;
    osg::ref_ptr<const BrickSet> bricks;
    const osg::GraphicsContext* owner = nullptr; //!< of contexts that share objects, the one whose passes do the work
    unsigned int nextStep = 0;                   //!< the number of the pass whose turn it is
    bool isComplete = false;
    std::vector<WorkingBatch> batches;
    Occupancy occupancy; //!< of the slab voxelized last
    GlBuffer buffer;     //!< of BrickPoint
    std::size_t brickCapacity = 0;
    std::size_t numBricks = 0;
    std::vector<Brick> readBack;
    LegoStatistics statistics;
};

/** What the passes of a node have under way in one context. */
struct PassContext : public osg::Referenced
{
    std::mutex mutex; //!< hold it for every use of the work
    std::unique_ptr<Legolization> work;
};

/** What the passes of a node share: the source that is wanted, what is under way in each context, the textures of
 * surfaces, and the store that the bricks are delivered to.
 *
 * Every function may be called from any thread.
 */
class PassWorkspace : public osg::Referenced
{
public:
    explicit PassWorkspace(BrickStore& store) : _store(&store) {}

    BrickStore& getStore() const { return *_store; }

    /** Want the bricks of a source from now on. @param bricks the set that stands for them once they are made. */
    void setSource(const LegoSource& source, const BrickSet& bricks);
    /** The source that is wanted; null at first. */
    osg::ref_ptr<const LegoSource> getSource() const;
    /** The set of that source. */
    osg::ref_ptr<const BrickSet> getBricks() const;

    /** The work of a context ID; none at first. */
    osg::ref_ptr<PassContext> getContext(unsigned int contextID) const;

    /** The texture of a surface, for any context; one and the same until releaseTextures(), or another source. */
    osg::ref_ptr<osg::Texture2D> getTexture(const SurfaceTexture& surface) const;
    /** Let go of the textures of surfaces, which are needed only to make bricks. */
    void releaseTextures() const;

    /** Let go of the GL objects of one context, or of all when `state` is null. */
    void releaseGLObjects(osg::State* state) const;

private:
    ~PassWorkspace() override = default;

    osg::ref_ptr<BrickStore> _store;
    mutable std::mutex _mutex;
    osg::ref_ptr<const LegoSource> _source;
    osg::ref_ptr<const BrickSet> _bricks;
    mutable std::map<unsigned int, osg::ref_ptr<PassContext>> _contexts;
    mutable std::map<const SurfaceTexture*, osg::ref_ptr<osg::Texture2D>> _textures;
};

} // namespace osgLego
