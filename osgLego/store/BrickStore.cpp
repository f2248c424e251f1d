#include <osgLego/store/BrickStore.h>

#include <osgLego/gl/ContextProgram.h>

#include <algorithm>
#include <utility>

#include <osg/Timer>

namespace osgLego
{

void BrickStore::expect(std::uint64_t revision, const BrickGrid& grid)
{
    const std::lock_guard lock(_mutex);
    _expectedRevision = revision;
    _expectedGrid = grid;
}

void BrickStore::deliver(const BrickSet& bricks)
{
    const std::lock_guard lock(_mutex);
    if (bricks.getRevision() < _leastRevision) return;
    // The draft of a source replaces the set for picking, which has no points.
    const bool isDraft = _bricks && !_bricks->hasPoints() && _bricks->getRevision() == bricks.getRevision() + 1;
    if (_bricks && _bricks->getRevision() > bricks.getRevision() && !isDraft) return;
    // A source may have two sets: one that every context can upload, and one whose points are on a GPU.
    if (_bricks && _bricks->getRevision() == bricks.getRevision() && _bricks->hasPoints()) return;
    _bricks = &bricks;
    const double now = osg::Timer::instance()->time_s();
    const bool isSoon = now - std::exchange(_deliveredAt, now) < ContextBricks::PAUSE;
    if (isSoon) _settlesAt = now + ContextBricks::PAUSE + ContextBricks::MARGIN;
    if (_highlight && bricks.hasPoints() && bricks.getModel() != &_highlight->getModel()) _highlight = nullptr;
}

void BrickStore::clear(std::uint64_t revision)
{
    const std::lock_guard lock(_mutex);
    _expectedRevision = 0;
    _leastRevision = revision;
    _bricks = nullptr;
    _building = nullptr;
    _highlight = nullptr;
    for (const auto& [contextID, bricks] : _contexts)
        bricks->hide(revision);
}

bool BrickStore::isSettling() const
{
    const std::lock_guard lock(_mutex);
    const bool isNew = osg::Timer::instance()->time_s() < _settlesAt;
    return std::ranges::any_of(_contexts,
                               [isNew](const auto& entry) {
                                   return entry.second->isSettling() || (isNew && entry.second->hasDistantOcclusion());
                               });
}

void BrickStore::deliver(const BuildingSet& building)
{
    const std::lock_guard lock(_mutex);
    const std::uint64_t least = _building ? _building->getRevision() : _leastRevision;
    if (building.getRevision() >= least) _building = &building;
}

osg::ref_ptr<const BuildingSet> BrickStore::getBuilding() const
{
    const std::lock_guard lock(_mutex);
    return _building;
}

void BrickStore::setState(const BuildingState& state)
{
    const std::lock_guard lock(_mutex);
    _state = state;
}

BuildingState BrickStore::getState() const
{
    const std::lock_guard lock(_mutex);
    return _state;
}

void BrickStore::setHighlight(const PartHighlight* highlight)
{
    const std::lock_guard lock(_mutex);
    _highlight = highlight;
}

osg::ref_ptr<const PartHighlight> BrickStore::getHighlight() const
{
    const std::lock_guard lock(_mutex);
    return _highlight;
}

osg::BoundingBoxd BrickStore::getBounds() const
{
    const std::lock_guard lock(_mutex);
    osg::BoundingBoxd bounds;
    if (_bricks) bounds = _bricks->getGrid().getBrickBounds();
    const bool isOnItsWay = _expectedRevision != 0 && !(_bricks && _bricks->getRevision() == _expectedRevision);
    if (isOnItsWay) bounds.expandBy(_expectedGrid.getBrickBounds());
    return bounds;
}

double BrickStore::getPitch() const
{
    const std::lock_guard lock(_mutex);
    // The frame that is being culled replaces a set made on a GPU by the expected one.
    const bool isShown = _bricks && (_bricks->hasPoints() || _bricks->getRevision() == _expectedRevision);
    return isShown ? _bricks->getGrid().getPitch() : _expectedGrid.getPitch();
}

osg::ref_ptr<const BrickSet> BrickStore::getBricks() const
{
    const std::lock_guard lock(_mutex);
    return _bricks;
}

osg::ref_ptr<ContextBricks> BrickStore::getContext(unsigned int contextID) const
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<ContextBricks>& bricks = _contexts[contextID];
    if (!bricks) bricks = new ContextBricks;
    return bricks;
}

void BrickStore::retryPrograms() const
{
    ContextProgram::allowRetry();
    const std::lock_guard lock(_mutex);
    for (const auto& [contextID, bricks] : _contexts)
        bricks->retryPrograms();
}

void BrickStore::releaseGLObjects(osg::State* state) const
{
    const std::lock_guard lock(_mutex);
    for (const auto& [contextID, bricks] : _contexts)
        if (!state || state->getContextID() == contextID) bricks->release();
}

} // namespace osgLego
