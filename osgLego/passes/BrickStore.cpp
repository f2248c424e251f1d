#include <osgLego/passes/BrickStore.h>

#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/passes/SurfaceBinding.h>

#include <osg/Notify>

namespace osgLego
{

std::string ContextBricks::getFailure() const
{
    const std::lock_guard lock(_mutex);
    return failure;
}

LegoStatistics ContextBricks::getStatistics() const
{
    const std::lock_guard lock(_mutex);
    return statistics;
}

osg::ref_ptr<const BrickModel> ContextBricks::getModel() const
{
    const std::lock_guard lock(_mutex);
    return model;
}

void ContextBricks::finish()
{
    buffer = std::move(work->bricks);
    numBricks = static_cast<GLsizei>(work->numBricks);
    blocks = std::move(work->blocks);
    source = work->source;
    work->statistics.numLegolizations = statistics.numLegolizations + 1;
    work->statistics.numDrawnBricks = work->numBricks;
    statistics = work->statistics;
    model = nullptr;
    if (source->readBack)
        model = work->model ? work->model : BrickModel::create(source->triangles->getGrid(), std::move(work->readBack));
    failure.clear();
    work.reset();
    _revision = source->revision;
}

void ContextBricks::fail(const LegoSource& failed, const std::string& why)
{
    work.reset();
    failure = why;
    if (_failedRevision.exchange(failed.revision) != failed.revision)
        OSG_WARN << "osgLego: " << why << "; the source is drawn as it is, not in bricks" << std::endl;
}

void ContextBricks::despair(unsigned int contextID, const std::string& why)
{
    {
        const std::lock_guard lock(_mutex);
        work.reset();
        failure = why;
        _isHopeless = true;
    }
    // Of all the nodes in a context one speaks.
    static std::mutex mutex;
    static std::map<unsigned int, std::string> said;
    const std::lock_guard lock(mutex);
    if (std::exchange(said[contextID], why) != why)
        OSG_WARN << "osgLego: " << why << "; sources are drawn as they are, not in bricks" << std::endl;
}

void ContextBricks::release()
{
    work.reset();
    buffer = GlBuffer();
    numBricks = 0;
    blocks.clear();
    source = nullptr;
    model = nullptr;
    failure.clear();
    _revision = 0;
    _failedRevision = 0;
    _isHopeless = false;
}

void BrickStore::setSource(const LegoSource* source)
{
    const std::lock_guard lock(_mutex);
    if (_source == source) return;
    _source = source;
    _textures.clear();
}

osg::ref_ptr<const LegoSource> BrickStore::getSource() const
{
    const std::lock_guard lock(_mutex);
    return _source;
}

osg::ref_ptr<ContextBricks> BrickStore::getContext(unsigned int contextID) const
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<ContextBricks>& bricks = _contexts[contextID];
    if (!bricks) bricks = new ContextBricks;
    return bricks;
}

osg::ref_ptr<const BrickModel> BrickStore::getModel() const
{
    if (const osg::ref_ptr<const LegoSource> wanted = getSource()) return getModel(*wanted);
    const std::lock_guard lock(_modelMutex);
    _modelSource = nullptr;
    _model = nullptr;
    return nullptr;
}

osg::ref_ptr<const BrickModel> BrickStore::getModel(const LegoSource& source) const
{
    const std::lock_guard lock(_modelMutex);
    if (_modelSource == &source) return _model;
    _modelSource = nullptr;
    _model = voxelizeOnCpu(*source.triangles);
    _modelSource = &source;
    return _model;
}

osg::ref_ptr<osg::Texture2D> BrickStore::getTexture(const SurfaceTexture& surface) const
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<osg::Texture2D>& texture = _textures[&surface];
    if (!texture) texture = createSurfaceTexture(surface);
    return texture;
}

void BrickStore::releaseTextures() const
{
    const std::lock_guard lock(_mutex);
    _textures.clear();
}

void BrickStore::releaseGLObjects(osg::State* state) const
{
    // Copies, since a pass locks its context first, and then the store.
    std::map<unsigned int, osg::ref_ptr<ContextBricks>> contexts;
    {
        const std::lock_guard lock(_mutex);
        for (const auto& [surface, texture] : _textures)
            texture->releaseGLObjects(state);
        contexts = _contexts;
    }
    for (const auto& [contextID, bricks] : contexts)
    {
        if (state && state->getContextID() != contextID) continue;
        const std::lock_guard contextLock(bricks->getMutex());
        bricks->release();
    }
}

} // namespace osgLego
