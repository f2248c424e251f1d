#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/data/BrickBlock.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/passes/LegoSource.h>
#include <osgLego/passes/Occupancy.h>

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
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
    const osg::GraphicsContext* owner = nullptr; //!< of contexts that share objects, the one whose passes do the work
    unsigned int nextStep = 0;                   //!< the number of the pass whose turn it is
    std::vector<WorkingBatch> batches;
    Occupancy occupancy; //!< of the slab voxelized last
    GlBuffer bricks;
    std::size_t brickCapacity = 0;
    std::size_t numBricks = 0;
    osg::ref_ptr<const BrickModel> model; //!< on the CPU, what voxelization found
    std::vector<BrickBlock> blocks;
    std::vector<Brick> readBack;
    LegoStatistics statistics;
};

/** The bricks of a node in one context, or in several that share objects. */
class ContextBricks : public osg::Referenced
{
public:
    /** Hold this for every use of the members that are not atomic. */
    std::mutex& getMutex() const { return _mutex; }

    /** Whether these are the bricks of a source. May be called from any thread, without the mutex. */
    bool isOf(const LegoSource& wanted) const { return _revision == wanted.revision; }
    /** The revision of the last source that could not be legolized; 0 when there is none. Likewise. */
    std::uint64_t getFailedRevision() const { return _failedRevision; }
    /** Whether the context lacks what the passes need. Likewise. */
    bool isHopeless() const { return _isHopeless; }
    // What the members below say, for who does not hold the mutex.
    std::string getFailure() const;
    LegoStatistics getStatistics() const;
    osg::ref_ptr<const BrickModel> getModel() const;

    /** Take over a legolization that is complete. */
    void finish();
    /** Give up the legolization under way, and say why, once. */
    void fail(const LegoSource& failed, const std::string& why);
    /** Give up on the context, and say why, once a context. The mutex is taken here. */
    void despair(unsigned int contextID, const std::string& why);
    /** Forget everything; the GL objects go through OSG's deferred deletion. */
    void release();

    std::unique_ptr<Legolization> work;
    GlBuffer buffer; //!< three unsigned ints a brick, as extraction writes them
    GLsizei numBricks = 0;
    std::vector<BrickBlock> blocks;        //!< all of the bricks, block by block; empty: the order is not known
    osg::ref_ptr<const LegoSource> source; //!< of the bricks
    osg::ref_ptr<const BrickModel> model;  //!< every covered cell, if the source asked for a read-back
    LegoStatistics statistics;
    std::string failure;

private:
    ~ContextBricks() override = default;

    mutable std::mutex _mutex;
    std::atomic<std::uint64_t> _revision{0};
    std::atomic<std::uint64_t> _failedRevision{0};
    std::atomic<bool> _isHopeless{false};
};

/** What a LegoNode, its passes and its drawable share: the source that is wanted, and the bricks of every context.
 *
 * Every function may be called from any thread.
 */
class BrickStore : public osg::Referenced
{
public:
    void setSource(const LegoSource* source);
    osg::ref_ptr<const LegoSource> getSource() const;

    /** The bricks of a context ID; made empty when there are none yet. */
    osg::ref_ptr<ContextBricks> getContext(unsigned int contextID) const;

    /** The bricks of the source on the CPU, made when first asked for and kept as long as the source is; null without
     * source. */
    osg::ref_ptr<const BrickModel> getModel() const;
    /** The same of a source that may not be the wanted one any more. */
    osg::ref_ptr<const BrickModel> getModel(const LegoSource& source) const;

    /** The texture of a surface, for any context; one and the same until releaseTextures(), or another source. */
    osg::ref_ptr<osg::Texture2D> getTexture(const SurfaceTexture& surface) const;
    /** Let go of the textures of surfaces, which are needed only to make bricks. */
    void releaseTextures() const;

    /** Let go of the GL objects of one context, or of all when `state` is null. */
    void releaseGLObjects(osg::State* state) const;

private:
    ~BrickStore() override = default;

    mutable std::mutex _mutex;
    osg::ref_ptr<const LegoSource> _source;
    mutable std::map<unsigned int, osg::ref_ptr<ContextBricks>> _contexts;
    mutable std::map<const SurfaceTexture*, osg::ref_ptr<osg::Texture2D>> _textures;
    mutable std::mutex _modelMutex; // apart, since making the model takes long
    mutable osg::ref_ptr<const BrickModel> _model;
    mutable osg::ref_ptr<const LegoSource> _modelSource;
};

} // namespace osgLego
