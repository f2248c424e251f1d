#include <osgLego/node/BrickSource.h>

#include <new>
#include <utility>

#include <osg/Notify>

namespace osgLego
{

bool BrickSource::setSettings(const LegoSettings& settings, const SettingsPalette& palette)
{
    const std::lock_guard lock(_mutex);
    const bool isShownAlike = settings.view.show == _request.settings.view.show;
    const bool givesSameBricks = settings.givesSameBricks(_request.settings) && palette == _request.palette;
    if (!givesSameBricks || !isShownAlike) _isDirty = true;
    _request.settings = settings;
    _request.settings.view.progress = LegoSettings().view.progress; // the store keeps the progress
    _request.palette = palette;
    return _stored && !isShownAlike;
}

LegoSettings BrickSource::getSettings() const
{
    const std::lock_guard lock(_mutex);
    return _request.settings;
}

SettingsPalette BrickSource::getPalette() const
{
    const std::lock_guard lock(_mutex);
    return _request.palette;
}

void BrickSource::setTiming(bool timing)
{
    const std::lock_guard lock(_mutex);
    if (std::exchange(_request.timing, timing) != timing) _isDirty = true;
}

bool BrickSource::getTiming() const
{
    const std::lock_guard lock(_mutex);
    return _request.timing;
}

void BrickSource::setReadBack(bool readBack)
{
    const std::lock_guard lock(_mutex);
    if (std::exchange(_request.readBack, readBack) != readBack) _isDirty = true;
}

bool BrickSource::getReadBack() const
{
    const std::lock_guard lock(_mutex);
    return _request.readBack;
}

bool BrickSource::setStored(const BrickModel* bricks)
{
    const std::lock_guard lock(_mutex);
    if (bricks == _stored) return false;
    _stored = bricks;
    if (!bricks) _watch.drop();
    _isDirty = !bricks;
    return true;
}

osg::ref_ptr<const BrickModel> BrickSource::getStored() const
{
    const std::lock_guard lock(_mutex);
    return _stored;
}

BrickSource::StoredRevisions BrickSource::numberStored(const BrickModel& bricks)
{
    const std::lock_guard lock(_mutex);
    StoredRevisions revisions;
    revisions.own = _watch.drop();
    if (_request.settings.view.show == Show::LOAD && !bricks.getParts().empty()) revisions.byLoad = _watch.drop();
    return revisions;
}

bool BrickSource::look(const osg::Node& node)
{
    const std::lock_guard lock(_mutex);
    const bool wasDirty = _isDirty.exchange(false);
    if (_stored) return false;
    using enum SourceWatch::Need;
    const bool wasContentDirty = _isContentDirty.exchange(false);
    try
    {
        return _watch.look(node, _request, wasContentDirty ? CONTENT : wasDirty ? REQUEST : NONE);
    }
    catch (const std::bad_alloc&)
    {
        _watch.fail("there is not enough memory for the triangles; expected fewer triangles");
        return true;
    }
}

std::uint64_t BrickSource::getRevision() const
{
    const std::lock_guard lock(_mutex);
    return _stored || _watch.getSource() ? _watch.getRevision() : 0;
}

std::uint64_t BrickSource::getLastRevision() const
{
    const std::lock_guard lock(_mutex);
    return _watch.getRevision();
}

osg::ref_ptr<const LegoSource> BrickSource::getSource() const
{
    const std::lock_guard lock(_mutex);
    return _watch.getSource();
}

osg::Matrixd BrickSource::getToNode() const
{
    const std::lock_guard lock(_mutex);
    return _stored ? osg::Matrixd() : _watch.getToNode();
}

std::string BrickSource::getObstacle() const
{
    const std::lock_guard lock(_mutex);
    return _watch.getObstacle();
}

void BrickSource::warnOfObstacle()
{
    const std::lock_guard lock(_mutex);
    const std::string& obstacle = _watch.getObstacle();
    if (std::exchange(_printedObstacle, obstacle) != obstacle && !obstacle.empty())
        OSG_WARN << "osgLego: " << obstacle << "; the source is drawn instead of bricks" << std::endl;
}

} // namespace osgLego
