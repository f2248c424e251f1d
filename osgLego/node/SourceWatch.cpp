#include <osgLego/node/SourceWatch.h>

#include <osgLego/data/SharedObjects.h>

#include <atomic>
#include <utility>
#include <vector>

#include <osg/Timer>
#include <osg/observer_ptr>

namespace osgLego
{

namespace
{

/** Number a source, and leave a number for the draft of its bricks (LegoSource::getDraftRevision()). */
std::uint64_t makeRevision()
{
    static std::atomic<std::uint64_t> last{0};
    return last += 2;
}

/** The values that determine the triangles of a source. */
struct TrianglesKey
{
    TrianglesKey(const osg::Node& node, const SourceSignature& ofSource, const LegoSettings& settings) :
        contents(hashSourceContents(node)), objects(ofSource.objects.begin(), ofSource.objects.end()),
        grid(settings.grid)
    {
    }

    bool operator==(const TrianglesKey&) const = default;

    std::uint64_t contents;
    std::vector<osg::observer_ptr<const osg::Referenced>> objects; // whose addresses are in the contents
    LegoSettings::Grid grid;
};

SharedObjects<TrianglesKey, const GridTriangles>& getSharedTriangles()
{
    static SharedObjects<TrianglesKey, const GridTriangles> triangles;
    return triangles;
}

} // namespace

bool SourceWatch::look(const osg::Node& node, const Request& request, Need need)
{
    const SourceSignature& signature = _signatures.compute(node);
    const bool hasMoved = _place.update(node, request.settings.grid.anchor == Anchor::WORLD);
    if (need == Need::NONE && !hasMoved && signature == _signature) return false;

    const osg::Timer_t start = osg::Timer::instance()->tick();
    const TrianglesKey key(node, signature, request.settings);
    if (need == Need::CONTENT) getSharedTriangles().forget(key);
    _isUnique = need == Need::CONTENT || (_isUnique && signature == _signature);
    _signature = signature;
    _revision = makeRevision();
    _obstacle.clear();
    LegoSettings settings = request.settings;
    const auto create = [&] { return flatten(node, settings); };
    // The lattice of another anchor depends on earlier sources, or on the place of the node.
    const bool isFitted = settings.grid.anchor == Anchor::FIT;
    if (isFitted) _lattice = {};
    const auto share = [&]
    {
        const osg::ref_ptr<const GridTriangles> created = create();
        return created ? GridTriangles::share(*created) : created;
    };
    const osg::ref_ptr<const GridTriangles> triangles =
        _isUnique || !isFitted ? create() : getSharedTriangles().findOrCreate(key, share);
    osg::ref_ptr<LegoSource> source;
    if (triangles) source = LegoSource::create(*triangles, settings, request.palette, _obstacle);
    if (source)
    {
        source->revision = _revision;
        source->flattening = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
        source->timing = request.timing;
        source->readBack = request.readBack;
    }
    _source = source;
    return true;
}

/** Flatten a source, and state its lattice in the settings. @return null if it has no visible triangles, or if there is
 * an obstacle. */
osg::ref_ptr<const GridTriangles> SourceWatch::flatten(const osg::Node& node, LegoSettings& settings)
{
    const osg::ref_ptr<const SceneTriangles> scene = SceneTriangles::create(node, _textures, _place.getToWorld());
    if (!std::exchange(_hasTexts, scene->getNumTexts() > 0)) scene->warnOfTexts(node);
    // The transforms above a node that is not in its scene yet, or in another scene, are not those of this world.
    if (std::exchange(_root, _place.getRoot()) != _place.getRoot()) _lattice = {};
    settings = _lattice.apply(scene->getBounds(), settings);
    _obstacle = _place.getObstacle();
    if (_obstacle.empty()) _obstacle = BrickGrid::findObstacle(scene->getBounds(), settings);
    return scene->getNumTriangles() > 0 && _obstacle.empty() ? GridTriangles::create(*scene, settings) : nullptr;
}

void SourceWatch::fail(const std::string& obstacle)
{
    drop();
    _obstacle = obstacle;
}

std::uint64_t SourceWatch::drop()
{
    _revision = makeRevision();
    _source = nullptr;
    _obstacle.clear();
    return _revision;
}

} // namespace osgLego
