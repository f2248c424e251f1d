#pragma once

#include <osgLego/data/BrickSet.h>
#include <osgLego/data/BuildingSet.h>
#include <osgLego/data/PartHighlight.h>
#include <osgLego/store/ContextBricks.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>

#include <osg/BoundingBox>
#include <osg/Referenced>
#include <osg/State>
#include <osg/ref_ptr>

namespace osgLego
{

/** How much of a model is shown. */
struct BuildingState
{
    double progress = 1.0;  //!< the share of parts in place, 0 to 1
    std::size_t numNew = 0; //!< the number of parts to highlight

    bool isWhole() const { return progress >= 1.0 && numNew == 0; }
};

/** The bricks that a LegoNode shows. Producers deliver them; drawing, picking, bounds and export read them.
 *
 * Every function may be called from any thread, but not while it holds the mutex of a ContextBricks.
 */
class BrickStore : public osg::Referenced
{
public:
    /** Announce the bricks that are being made: the revision of their source, and their grid. */
    void expect(std::uint64_t revision, const BrickGrid& grid);
    /** Show a set from now on, unless a newer one has been delivered. */
    void deliver(const BrickSet& bricks);
    /** Show no bricks: the source has no triangles. */
    void clear(std::uint64_t revision);
    /** The newest set delivered; null if there is none. */
    osg::ref_ptr<const BrickSet> getBricks() const;

    /** Show a set while the model is drawn partly built, unless one for newer bricks has been delivered. */
    void deliver(const BuildingSet& building);
    /** The last such set, which may be older than the bricks; null if there is none. */
    osg::ref_ptr<const BuildingSet> getBuilding() const;
    void setState(const BuildingState& state);
    BuildingState getState() const;
    /** Highlight parts until bricks of another model are delivered; null: none. */
    void setHighlight(const PartHighlight* highlight);
    osg::ref_ptr<const PartHighlight> getHighlight() const;

    /** Whether frames within the next moments change the occlusion of bricks (ContextBricks::isSettling()). */
    bool isSettling() const;

    /** The bounds of the newest set and, until it is the expected one, of the expected bricks. In model units, studs
     * included; invalid if there are no bricks. */
    osg::BoundingBoxd getBounds() const;
    /** The width of the bricks that the next frame shows, in model units. */
    double getPitch() const;

    /** The bricks of a context ID; initially empty. */
    osg::ref_ptr<ContextBricks> getContext(unsigned int contextID) const;

    /** Have each context try programs again that could not be compiled or linked there. */
    void retryPrograms() const;

    /** Release the GL objects of one context, or of all contexts if `state` is null. */
    void releaseGLObjects(osg::State* state) const;

private:
    ~BrickStore() override = default;

    mutable std::mutex _mutex;
    std::uint64_t _expectedRevision = 0; // 0: nothing is expected
    BrickGrid _expectedGrid;
    std::uint64_t _leastRevision = 0; // sets of older sources are not shown any more
    osg::ref_ptr<const BrickSet> _bricks;
    double _deliveredAt = -ContextBricks::PAUSE; // seconds
    double _settlesAt = 0.0;
    osg::ref_ptr<const BuildingSet> _building;
    BuildingState _state;
    osg::ref_ptr<const PartHighlight> _highlight;
    mutable std::map<unsigned int, osg::ref_ptr<ContextBricks>> _contexts;
};

} // namespace osgLego
