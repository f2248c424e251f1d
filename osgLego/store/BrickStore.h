#pragma once

#include <osgLego/data/BrickSet.h>
#include <osgLego/store/ContextBricks.h>

#include <cstdint>
#include <map>
#include <mutex>

#include <osg/BoundingBox>
#include <osg/Referenced>
#include <osg/State>
#include <osg/ref_ptr>

namespace osgLego
{

/** The bricks that a LegoNode shows: where producers deliver, and what drawing, picking, bounds and export read.
 *
 * Every function may be called from any thread.
 */
class BrickStore : public osg::Referenced
{
public:
    /** Say which source bricks are being made of, by its revision, and what grid they will be in. */
    void expect(std::uint64_t revision, const BrickGrid& grid);
    /** Show a set from now on, unless a newer one is there already. */
    void deliver(const BrickSet& bricks);
    /** Show no bricks: the source has no triangles. */
    void clear();
    /** The newest set delivered; null when there is none. */
    osg::ref_ptr<const BrickSet> getBricks() const;

    /** Where bricks are: those of the newest set and, until that is the expected one, the expected ones. In model
     * units, studs included; invalid when there are none. */
    osg::BoundingBoxd getBounds() const;
    /** The width of the bricks of the newest set, or of the expected one while there is none; in model units. */
    double getPitch() const;

    /** The bricks of a context ID; empty at first. */
    osg::ref_ptr<ContextBricks> getContext(unsigned int contextID) const;

    /** Let go of the GL objects of one context, or of all when `state` is null. */
    void releaseGLObjects(osg::State* state) const;

private:
    ~BrickStore() override = default;

    mutable std::mutex _mutex;
    std::uint64_t _expectedRevision = 0; // 0: nothing is expected
    BrickGrid _expectedGrid;
    osg::ref_ptr<const BrickSet> _bricks;
    mutable std::map<unsigned int, osg::ref_ptr<ContextBricks>> _contexts;
};

} // namespace osgLego
