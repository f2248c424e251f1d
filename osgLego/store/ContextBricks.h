#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/data/BrickBlock.h>
#include <osgLego/data/BrickSet.h>
#include <osgLego/data/BuildingSet.h>
#include <osgLego/data/PartHighlight.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/store/BlockReader.h>
#include <osgLego/store/DistantOcclusionTexture.h>
#include <osgLego/store/GridOcclusionTextures.h>
#include <osgLego/store/PartialOcclusion.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include <osg/Referenced>
#include <osg/State>
#include <osg/Timer>
#include <osg/ref_ptr>

namespace osgLego
{

/** Bricks that the passes made in a context, ready to be shown there. */
struct GpuBricks
{
    osg::ref_ptr<const BrickSet> bricks;
    GlBuffer buffer;    //!< of BrickPoint; the bricks of a block are consecutive
    GlBuffer neighbors; //!< of BrickNeighbors; empty if they are not known
    GLsizei numBricks = 0;
    osg::ref_ptr<const BrickModel> model; //!< every covered cell, if a read-back was requested
    LegoStatistics statistics;
};

/** The bricks of a node in one context, or in several contexts that share GL objects: a brick set, and its points in a
 * buffer. */
class ContextBricks : public osg::Referenced
{
public:
    /** The mutex to hold for every use of the members that are not atomic. */
    std::mutex& getMutex() const { return _mutex; }

    /** Bricks that are shown less than this after those before may have their distant occlusion. In seconds. */
    static constexpr double PAUSE = 0.5;
    /** Beyond PAUSE, the time within which a frame is drawn that shows their own. */
    static constexpr double MARGIN = 0.1;

    // These functions may be called from any thread, without the mutex.
    /** Whether distant occlusion is shown. */
    bool hasDistantOcclusion() const { return _hasDistant; }
    /** Whether the occlusion shown may be that of earlier bricks, which frames within the next moments change. */
    bool isSettling() const;
    /** Whether these are the bricks of the source with this revision. */
    bool isOf(std::uint64_t revision) const { return _revision == revision; }
    /** Whether there are no bricks to show. */
    bool isEmpty() const { return _revision == 0; }
    /** The revision of the last source that could not be shown; 0 if there is none. */
    std::uint64_t getFailedRevision() const { return _failedRevision; }
    /** Whether the context lacks GL features that bricks need. */
    bool isUnsupported() const { return _isUnsupported; }
    /** Whether programs could not be compiled or linked, since the last call of retryPrograms(). */
    bool lacksPrograms() const { return _lacksPrograms; }
    /** Whether the bricks of the source with this revision are shown, rather than the source because of a failure. */
    bool shows(std::uint64_t revision) const
    {
        return isOf(revision) && _failedRevision != revision && !_isUnsupported && !_lacksPrograms;
    }
    std::string getFailure() const;
    LegoStatistics getStatistics() const;
    osg::ref_ptr<const BrickModel> getModel() const;

    /** Show bricks that the passes made in this context, which must be current. Locks the mutex. */
    void show(const osg::State& state, GpuBricks&& made);
    /** Upload the points of bricks made on the CPU, and show them, unless newer ones are shown. The caller holds the
     * mutex, and the context is current. */
    void upload(const osg::State& state, const BrickSet& wanted);
    /** Upload a set for drawing the model partly built, unless it is there. The caller holds the mutex, and the context
     * is current.
     * @return whether there was enough memory. */
    bool upload(const osg::State& state, const BuildingSet& wanted);
    /** Colour the parts of a highlight in the points that were uploaded; null: none. Does nothing if they are coloured
     * already, and without memory. The caller holds the mutex, and the context is current. */
    void highlight(const osg::State& state, const PartHighlight* wanted);
    /** Check for the blocks of bricks made on the GPU. The caller holds the mutex, and the context is current. */
    void pollBlocks(const osg::State& state);
    /** Note that frames wait for bricks, which therefore never have the distant occlusion of earlier ones. */
    void setAwaited(bool isAwaited) { _isAwaited = isAwaited; }
    /** The distant occlusion of the bricks as a texture, created by the first call after they were shown. For bricks
     * made on the GPU, this call waits until they have been read. While sets follow each other in less than PAUSE
     * seconds, it returns that of earlier bricks, unless the set has its own already. The caller holds the mutex, and
     * the context is current.
     * @return null if there are no bricks, or no memory for reading them. */
    DistantOcclusionTexture* findDistantOcclusion(const osg::State& state, NearOcclusion near);

    /** Whether the last result of findDistantOcclusion() is that of earlier bricks. The caller holds the mutex. */
    bool hasOldDistantOcclusion(NearOcclusion near) const { return _distant[static_cast<std::size_t>(near)].isOld; }

    /** The grid occlusion of the bricks as textures, created by the first call after they were shown. For bricks made
     * on the GPU without neighbours, this call waits until they have been read. The caller holds the mutex, and the
     * context is current.
     * @return null if there are no bricks, or no memory. */
    const GridOcclusionTextures* findGridOcclusion(const osg::State& state);
    /** The grid occlusion of the model partly built, created by the first call after its upload. The caller holds the
     * mutex, and the context is current.
     * @return null if there is no such model, or no memory. */
    PartialOcclusion* findPartialOcclusion(const osg::State& state);

    /** Report once, with the reason, that a source can't be shown. Locks the mutex. */
    void fail(std::uint64_t revision, const std::string& why);
    /** Report once that a program could not be compiled or linked, which is the same for every source. Locks the
     * mutex. */
    void failPrograms(const std::string& why);
    /** Forget that programs have failed. Locks the mutex. */
    void retryPrograms();
    /** Give up on the context, and report the reason once for all nodes in it. Locks the mutex. */
    void markUnsupported(unsigned int contextID, const std::string& why);
    /** Stop showing bricks. Locks the mutex. */
    void hide(std::uint64_t revision);
    /** Reset everything, and release the GL objects through OSG's deferred deletion. Locks the mutex. */
    void release();

    // The bricks that are shown. The caller holds the mutex.
    osg::ref_ptr<const BrickSet> bricks;
    GlBuffer buffer;
    GLsizei numBricks = 0;
    std::vector<BrickBlock> blocks; //!< all bricks, block by block; empty while the blocks are unknown

    // The set for drawing the model partly built. The caller holds the mutex.
    osg::ref_ptr<const BuildingSet> building;
    GlBuffer buildingBuffer; //!< of BrickPoint
    GlBuffer rankBuffer;     //!< of CellRanks

private:
    ~ContextBricks() override = default;

    /** The distant occlusion that completes one kind of near occlusion. */
    struct Distant
    {
        bool isWanted = false;
        osg::ref_ptr<DistantOcclusionTexture> texture; // null until it is wanted
        bool isOld = false;                            // of earlier bricks
    };

    void clear();
    void noteNewBricks();
    bool isMoving() const;
    void uploadNeighbors(const osg::State& state, std::span<const BrickNeighbors> neighbors);
    bool lacksMemoryForOcclusion();
    void readPoints(const osg::State& state);
    void usePoints(const osg::State& state, std::span<const BrickPoint> points);
    void setFailure(std::uint64_t revision, const std::string& why);

    mutable std::mutex _mutex;
    BlockReader _blockReader;
    osg::ref_ptr<const PartHighlight> _highlight;         // in the points of the bricks
    osg::ref_ptr<const PartHighlight> _buildingHighlight; // in those of the model partly built
    bool _wantsGridOcclusion = false;
    bool _lacksMemoryForOcclusion = false; // of bricks that are shown
    osg::ref_ptr<GridOcclusionTextures> _gridOcclusion;
    osg::ref_ptr<PartialOcclusion> _partialOcclusion;
    std::array<Distant, 2> _distant; // by NearOcclusion
    osg::Timer_t _shownAt = 0;       // when the bricks were shown
    bool _isSoon = false;            // less than PAUSE after those before
    std::atomic<bool> _isAwaited{false};
    std::atomic<bool> _hasDistant{false};
    std::atomic<double> _settlesAt{0.0}; // seconds
    osg::ref_ptr<const BrickModel> _model;
    LegoStatistics _statistics;
    std::string _failure;
    std::uint64_t _leastRevision = 0; // bricks of older sources are not shown any more
    std::atomic<std::uint64_t> _revision{0};
    std::atomic<std::uint64_t> _failedRevision{0};
    std::atomic<bool> _isUnsupported{false};
    std::atomic<bool> _lacksPrograms{false};
};

} // namespace osgLego
