#include <osgLego/node/BrickQuery.h>

#include <osgLego/BrickGeometry.h>
#include <osgLego/producer/GpuProducer.h>

#include <osg/observer_ptr>

namespace osgLego
{

osg::ref_ptr<const BrickModel> BrickQuery::getModel(const LegoSource& source)
{
    const osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    const bool isLazy = source.settings.needsCpu() && newest && !newest->hasPoints();
    if (newest && newest->getRevision() == source.revision && !isLazy) return newest->getModel();
    const osg::ref_ptr<const BrickSet> made = makeOnCpu(source);
    return made ? made->getModel() : nullptr;
}

/** Wait for the bricks of a source. @return null, with the reason in getFailure(), if they can't be made. */
osg::ref_ptr<const BrickSet> BrickQuery::makeOnCpu(const LegoSource& source)
{
    std::string error;
    const osg::ref_ptr<const BrickSet> bricks = _producer->getBricks(source, error);
    const std::lock_guard lock(_mutex);
    _failedRevision = bricks ? 0 : source.revision;
    _failure = error;
    return bricks;
}

/** Create a set whose model the producer makes when it is needed: few visitors look at triangles. Frames show these
 * bricks, too, since bricks that the GPU can't make take long to make again. */
osg::ref_ptr<const BrickSet> BrickQuery::createLazySet(const LegoSource& source) const
{
    // Not a reference: the producer has the store, and the store has the set.
    const auto makeModel = [observed = osg::observer_ptr<CpuProducer>(_producer),
                            kept = osg::ref_ptr<const LegoSource>(&source)]() -> osg::ref_ptr<const BrickModel>
    {
        osg::ref_ptr<CpuProducer> producer;
        if (!observed.lock(producer)) return nullptr;
        std::string ignored; // frames report it
        const osg::ref_ptr<const BrickSet> bricks = producer->getBricks(*kept, ignored);
        return bricks ? bricks->getModel() : nullptr;
    };
    return new BrickSet(source.revision, source.triangles->getGrid(), makeModel);
}

void BrickQuery::prepareForPicking(const LegoSource& source)
{
    const osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    // A set that is shown is picked until the next set is shown. A set made only for picking must match the source.
    const bool isShown = newest && (newest->hasPoints() || newest->getRevision() == source.revision);
    if (isShown) return;
    _store->deliver(source.settings.needsCpu() ? *createLazySet(source) : *createGpuBrickSet(source));
}

std::string BrickQuery::getFailure(std::uint64_t revision) const
{
    const std::lock_guard lock(_mutex);
    return _failedRevision != 0 && _failedRevision == revision ? _failure : std::string();
}

osg::ref_ptr<osg::Geode> BrickQuery::getGeometryNode(const BrickModel& model)
{
    const std::lock_guard lock(_mutex);
    if (&model != _model)
    {
        _model = &model;
        _geometryNode = new osg::Geode;
        _geometryNode->addDrawable(createBrickGeometry(model));
    }
    return _geometryNode;
}

void BrickQuery::resizeGLObjectBuffers(unsigned int maxSize)
{
    const std::lock_guard lock(_mutex);
    if (_geometryNode) _geometryNode->resizeGLObjectBuffers(maxSize);
}

void BrickQuery::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    if (_geometryNode) _geometryNode->releaseGLObjects(state);
}

} // namespace osgLego
