#include <osgLego/store/ContextBricks.h>

#include <osgLego/gl/GlMemory.h>

#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include <osg/Notify>
#include <osg/Timer>

namespace osgLego
{

namespace
{

/** Create a buffer. The caller checks for lack of memory. */
template <typename Item>
GlBuffer createBuffer(const osg::State& state, const std::vector<Item>& items)
{
    GlBuffer buffer(state);
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(),
                            GL_STATIC_DRAW);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
    return buffer;
}

/** Replace a buffer of points by one in which a highlight is shown, or no longer shown.
 * @param shown the highlight in the buffer.
 * @param wanted null, or a highlight of any model. */
void showHighlight(const osg::State& state, const BrickModel& model, const std::vector<BrickPoint>& points,
                   const PartHighlight* wanted, osg::ref_ptr<const PartHighlight>& shown, GlBuffer& buffer)
{
    if (wanted && &wanted->getModel() != &model) wanted = nullptr;
    if (wanted == shown) return;
    shown = wanted;
    GlBuffer uploaded = createBuffer(state, wanted ? wanted->apply(points) : points);
    if (!takeOutOfMemoryError()) buffer = std::move(uploaded);
}

std::string describeLackOfMemory(std::size_t numBricks)
{
    return "there is not enough memory on the GPU for " + std::to_string(numBricks) +
           " bricks; expected a lower resolution";
}

void warnOfFailure(const std::string& why)
{
    OSG_WARN << "osgLego: " << why << "; the source is drawn instead of bricks" << std::endl;
}

} // namespace

std::string ContextBricks::getFailure() const
{
    const std::lock_guard lock(_mutex);
    return _failure;
}

LegoStatistics ContextBricks::getStatistics() const
{
    osg::ref_ptr<const BrickSet> set;
    LegoStatistics statistics;
    {
        const std::lock_guard lock(_mutex);
        set = bricks;
        statistics = _statistics;
    }
    if (set) statistics.layout = set->getLayoutStatistics();
    return statistics;
}

bool ContextBricks::isSettling() const
{
    return _hasDistant && !_isAwaited && osg::Timer::instance()->time_s() < _settlesAt;
}

osg::ref_ptr<const BrickModel> ContextBricks::getModel() const
{
    const std::lock_guard lock(_mutex);
    return _model;
}

void ContextBricks::show(const osg::State& state, GpuBricks&& made)
{
    const std::lock_guard lock(_mutex);
    if (made.bricks->getRevision() < _leastRevision) return;
    bricks = made.bricks;
    buffer = std::move(made.buffer);
    _highlight = nullptr;
    numBricks = made.numBricks;
    blocks.clear();
    noteNewBricks();
    if (made.neighbors.get() != 0)
        _gridOcclusion = new GridOcclusionTextures(state, bricks->getGrid(), std::move(made.neighbors), numBricks);
    _blockReader.start(state, buffer.get(), numBricks);
    _model = made.model;
    const unsigned int numBefore = _statistics.numLegolizations;
    _statistics = made.statistics;
    _statistics.numLegolizations = numBefore + 1;
    _statistics.numDrawnBricks = static_cast<std::size_t>(numBricks);
    _failure.clear();
    _revision = bricks->getRevision();
}

void ContextBricks::upload(const osg::State& state, const BrickSet& wanted)
{
    if (wanted.getRevision() < _leastRevision || _revision >= wanted.getRevision() ||
        _failedRevision == wanted.getRevision())
        return;
    const osg::Timer_t start = osg::Timer::instance()->tick();
    const std::vector<BrickPoint>& points = wanted.getPoints().points;
    GlBuffer uploaded = createBuffer(state, points);
    if (takeOutOfMemoryError())
    {
        setFailure(wanted.getRevision(), describeLackOfMemory(points.size()));
        return;
    }
    bricks = &wanted;
    buffer = std::move(uploaded);
    _highlight = nullptr;
    numBricks = static_cast<GLsizei>(points.size());
    blocks = wanted.getPoints().blocks;
    noteNewBricks();
    _blockReader.stop();
    _model = wanted.getModel();
    const unsigned int numBefore = _statistics.numLegolizations;
    _statistics = wanted.getStatistics();
    _statistics.numLegolizations = numBefore + 1;
    _statistics.extraction = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    _failure.clear();
    _revision = wanted.getRevision();
}

bool ContextBricks::upload(const osg::State& state, const BuildingSet& wanted)
{
    if (building == &wanted) return true;
    if (_failedRevision == wanted.getRevision()) return false;
    const BuildingPoints& points = wanted.getPoints();
    GlBuffer uploaded = createBuffer(state, points.points);
    GlBuffer ranks = createBuffer(state, points.ranks);
    if (takeOutOfMemoryError())
    {
        setFailure(wanted.getRevision(), describeLackOfMemory(points.points.size()));
        return false;
    }
    building = &wanted;
    _partialOcclusion = nullptr;
    _lacksMemoryForOcclusion = false;
    buildingBuffer = std::move(uploaded);
    _buildingHighlight = nullptr;
    rankBuffer = std::move(ranks);
    return true;
}

void ContextBricks::highlight(const osg::State& state, const PartHighlight* wanted)
{
    if (bricks && bricks->hasPoints())
        showHighlight(state, *bricks->getModel(), bricks->getPoints().points, wanted, _highlight, buffer);
    if (building)
        showHighlight(state, building->getModel(), building->getPoints().points, wanted, _buildingHighlight,
                      buildingBuffer);
}

void ContextBricks::pollBlocks(const osg::State& state)
{
    _blockReader.poll(state, false, [&](std::span<const BrickPoint> points) { usePoints(state, points); });
}

/** Wait until the bricks, which were made on the GPU, have been read. */
void ContextBricks::readPoints(const osg::State& state)
{
    if (!_blockReader.isReading()) _blockReader.start(state, buffer.get(), numBricks);
    _blockReader.poll(state, true, [&](std::span<const BrickPoint> points) { usePoints(state, points); });
}

void ContextBricks::usePoints(const osg::State& state, std::span<const BrickPoint> points)
{
    blocks = findBlocks(points);
    if (_wantsGridOcclusion && !_gridOcclusion) uploadNeighbors(state, createBrickNeighbors(points));
    for (const NearOcclusion near : {NearOcclusion::PICTURE, NearOcclusion::GRID})
    {
        Distant& distant = _distant[static_cast<std::size_t>(near)];
        if (!distant.isWanted || (distant.texture && (!distant.isOld || isMoving()))) continue;
        distant.texture =
            new DistantOcclusionTexture(*DistantOcclusion::create(bricks->getGrid(), points, near), bricks->getGrid());
        distant.isOld = false;
    }
}

/** Drop the occlusion of earlier bricks, except for distant occlusion, which changes little. */
void ContextBricks::noteNewBricks()
{
    const osg::Timer& timer = *osg::Timer::instance();
    const osg::Timer_t now = timer.tick();
    _isSoon = timer.delta_s(std::exchange(_shownAt, now), now) < PAUSE;
    if (_isSoon) _settlesAt = timer.time_s() + PAUSE + MARGIN;
    _gridOcclusion = nullptr;
    _lacksMemoryForOcclusion = false;
    for (Distant& distant : _distant)
        distant.isOld = true;
}

/** Whether the bricks are so new that others are likely to follow. */
bool ContextBricks::isMoving() const
{
    const osg::Timer& timer = *osg::Timer::instance();
    return _isSoon && !_isAwaited && timer.delta_s(_shownAt, timer.tick()) < PAUSE;
}

DistantOcclusionTexture* ContextBricks::findDistantOcclusion(const osg::State& state, NearOcclusion near)
{
    Distant& distant = _distant[static_cast<std::size_t>(near)];
    distant.isWanted = true;
    _hasDistant = true;
    if ((distant.texture && !distant.isOld) || numBricks == 0) return distant.texture;
    const bool isReady = bricks->hasDistantOcclusion(near);
    if (distant.texture && !isReady && isMoving()) return distant.texture;
    if (bricks->hasPoints())
    {
        distant.texture = new DistantOcclusionTexture(bricks->getDistantOcclusion(near), bricks->getGrid());
        distant.isOld = false;
    }
    else
        readPoints(state);
    return distant.texture;
}

const GridOcclusionTextures* ContextBricks::findGridOcclusion(const osg::State& state)
{
    _wantsGridOcclusion = true;
    if (_gridOcclusion || numBricks == 0 || _lacksMemoryForOcclusion) return _gridOcclusion;
    if (bricks->hasPoints())
        uploadNeighbors(state, bricks->getNeighbors());
    else
        readPoints(state);
    return _gridOcclusion;
}

void ContextBricks::uploadNeighbors(const osg::State& state, std::span<const BrickNeighbors> neighbors)
{
    _gridOcclusion = new GridOcclusionTextures(state, bricks->getGrid(), neighbors);
    if (lacksMemoryForOcclusion()) _gridOcclusion = nullptr;
}

PartialOcclusion* ContextBricks::findPartialOcclusion(const osg::State& state)
{
    if (_partialOcclusion || !building || _lacksMemoryForOcclusion) return _partialOcclusion;
    _partialOcclusion = new PartialOcclusion(state, *building);
    if (lacksMemoryForOcclusion()) _partialOcclusion = nullptr;
    return _partialOcclusion;
}

/** Check for lack of memory after an upload, and report it once for each set of bricks. */
bool ContextBricks::lacksMemoryForOcclusion()
{
    if (!takeOutOfMemoryError()) return false;
    _lacksMemoryForOcclusion = true;
    OSG_WARN << "osgLego: there is not enough memory on the GPU for the occlusion of bricks; they are drawn without, "
                "expected a lower resolution"
             << std::endl;
    return true;
}

void ContextBricks::fail(std::uint64_t revision, const std::string& why)
{
    const std::lock_guard lock(_mutex);
    setFailure(revision, why);
}

void ContextBricks::setFailure(std::uint64_t revision, const std::string& why)
{
    _failure = why;
    if (_failedRevision.exchange(revision) != revision) warnOfFailure(why);
}

void ContextBricks::failPrograms(const std::string& why)
{
    const std::lock_guard lock(_mutex);
    if (_lacksPrograms.exchange(true)) return;
    _failure = why;
    warnOfFailure(why);
}

void ContextBricks::retryPrograms()
{
    const std::lock_guard lock(_mutex);
    if (_lacksPrograms.exchange(false)) _failure.clear();
}

void ContextBricks::markUnsupported(unsigned int contextID, const std::string& why)
{
    {
        const std::lock_guard lock(_mutex);
        _failure = why;
        _isUnsupported = true;
    }
    // Only one of the nodes in a context prints the warning.
    static std::mutex mutex;
    static std::map<unsigned int, std::string> said;
    const std::lock_guard lock(mutex);
    if (std::exchange(said[contextID], why) != why)
        OSG_WARN << "osgLego: " << why << "; sources are drawn instead of bricks" << std::endl;
}

void ContextBricks::hide(std::uint64_t revision)
{
    const std::lock_guard lock(_mutex);
    _leastRevision = revision;
    clear();
}

/** Drop the bricks. */
void ContextBricks::clear()
{
    bricks = nullptr;
    building = nullptr;
    buffer = GlBuffer();
    buildingBuffer = GlBuffer();
    _highlight = nullptr;
    _buildingHighlight = nullptr;
    rankBuffer = GlBuffer();
    numBricks = 0;
    blocks.clear();
    _gridOcclusion = nullptr;
    _partialOcclusion = nullptr;
    for (Distant& distant : _distant)
        distant.texture = nullptr;
    _blockReader.stop();
    _model = nullptr;
    const unsigned int numLegolizations = _statistics.numLegolizations;
    _statistics = LegoStatistics();
    _statistics.numLegolizations = numLegolizations;
    _revision = 0;
}

void ContextBricks::release()
{
    const std::lock_guard lock(_mutex);
    clear();
    _blockReader.forget();
    _failure.clear();
    _failedRevision = 0;
    _isUnsupported = false;
    _lacksPrograms = false;
}

} // namespace osgLego
