#include <osgLego/producer/MadeBricks.h>

#include <osgLego/data/SharedObjects.h>

#include <osg/observer_ptr>

namespace osgLego
{

namespace
{

/** Everything that bricks depend on. */
struct SourceKey
{
    explicit SourceKey(const LegoSource& source) :
        triangles(source.triangles.get()), palette(source.lookup.getPalette()), settings(source.settings)
    {
    }

    bool operator==(const SourceKey& other) const
    {
        return triangles == other.triangles && palette == other.palette && settings.givesSameBricks(other.settings);
    }

    osg::observer_ptr<const GridTriangles> triangles;
    osg::observer_ptr<const Palette> palette;
    LegoSettings settings;
};

SharedObjects<SourceKey, const MadeBricks>& getShared()
{
    static SharedObjects<SourceKey, const MadeBricks> bricks;
    return bricks;
}

} // namespace

osg::ref_ptr<const MadeBricks> MadeBricks::find(const LegoSource& source)
{
    return getShared().find(SourceKey(source));
}

osg::ref_ptr<const MadeBricks> MadeBricks::share(const LegoSource& source, const MadeBricks& bricks)
{
    return getShared().findOrCreate(SourceKey(source), [&] { return &bricks; });
}

} // namespace osgLego
