#include <osgLego/node/SourceWatch.h>

#include <atomic>
#include <utility>

#include <osg/Timer>

namespace osgLego
{

namespace
{

std::uint64_t makeRevision()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

} // namespace

bool SourceWatch::look(const osg::Node& node, const Request& request, bool isDirty)
{
    const SourceSignature& signature = _signatures.compute(node);
    if (!isDirty && signature == _signature) return false;

    const osg::Timer_t start = osg::Timer::instance()->tick();
    const osg::ref_ptr<const SceneTriangles> scene = SceneTriangles::create(node, _textures);
    if (!std::exchange(_hasTexts, scene->getNumTexts() > 0)) scene->warnOfTexts(node);
    _revision = makeRevision();
    osg::ref_ptr<LegoSource> source;
    _obstacle = BrickGrid::findObstacle(scene->getBounds(), request.settings);
    if (scene->getNumTriangles() > 0 && _obstacle.empty())
        source = LegoSource::create(*scene, request.settings, request.palette, _obstacle);
    if (source)
    {
        source->revision = _revision;
        source->flattening = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
        source->timing = request.timing;
        source->readBack = request.readBack;
    }
    _source = source;
    _signature = signature;
    return true;
}

std::uint64_t SourceWatch::drop()
{
    _revision = makeRevision();
    _source = nullptr;
    _obstacle.clear();
    return _revision;
}

} // namespace osgLego
