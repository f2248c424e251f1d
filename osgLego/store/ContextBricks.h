#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/data/BrickBlock.h>
#include <osgLego/data/BrickSet.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/store/BlockReader.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include <osg/Referenced>
#include <osg/State>
#include <osg/ref_ptr>

namespace osgLego
{

/** Bricks that the passes made in a context, to be shown there. */
struct GpuBricks
{
    osg::ref_ptr<const BrickSet> bricks;
    GlBuffer buffer; //!< of BrickPoint; those of a block follow each other
    GLsizei numBricks = 0;
    osg::ref_ptr<const BrickModel> model; //!< every covered cell, where a read-back was asked for
    LegoStatistics statistics;
};

/** The bricks of a node in one context, or in several that share objects: a brick set and its points in a buffer. */
class ContextBricks : public osg::Referenced
{
public:
    /** Hold this for every use of the members that are not atomic. */
    std::mutex& getMutex() const { return _mutex; }

    // These may be called from any thread, without the mutex.
    /** Whether these are the bricks of a source, by its revision. */
    bool isOf(std::uint64_t revision) const { return _revision == revision; }
    /** Whether there are no bricks to show. */
    bool isEmpty() const { return _revision == 0; }
    /** The revision of the last source that could not be shown; 0 when there is none. */
    std::uint64_t getFailedRevision() const { return _failedRevision; }
    /** Whether the context lacks the GL that bricks need. */
    bool isHopeless() const { return _isHopeless; }
    std::string getFailure() const;
    LegoStatistics getStatistics() const;
    osg::ref_ptr<const BrickModel> getModel() const;

    /** Show bricks that the passes made in this context, which must be current. Takes the mutex. */
    void show(const osg::State& state, GpuBricks&& made);
    /** Show bricks made on the CPU, unless newer ones are shown: upload their points. Needs the mutex, and the context
     * current. */
    void upload(const osg::State& state, const BrickSet& wanted);
    /** Look whether the blocks of bricks made by the GPU have arrived. Needs the mutex, and the context current. */
    void pollBlocks(const osg::State& state);

    /** Report that a source can't be shown, and why, once. Takes the mutex. */
    void fail(std::uint64_t revision, const std::string& why);
    /** Give up on the context, and say why, once for all nodes in it. Takes the mutex. */
    void despair(unsigned int contextID, const std::string& why);
    /** Show no bricks any more. Takes the mutex. */
    void hide();
    /** Forget everything; the GL objects go through OSG's deferred deletion. Takes the mutex. */
    void release();

    // Of the bricks that are shown; these need the mutex.
    osg::ref_ptr<const BrickSet> bricks;
    GlBuffer buffer;
    GLsizei numBricks = 0;
    std::vector<BrickBlock> blocks; //!< of all bricks, block by block; empty while they are not known

private:
    ~ContextBricks() override = default;

    void clear();
    void setFailure(std::uint64_t revision, const std::string& why);

    mutable std::mutex _mutex;
    BlockReader _blockReader;
    osg::ref_ptr<const BrickModel> _model;
    LegoStatistics _statistics;
    std::string _failure;
    std::atomic<std::uint64_t> _revision{0};
    std::atomic<std::uint64_t> _failedRevision{0};
    std::atomic<bool> _isHopeless{false};
};

} // namespace osgLego
