#pragma once

#include <osgLego/flattening/LegoSource.h>

#include <osg/Referenced>
#include <osg/State>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** A way from a source to an immutable brick set (BrickSet), which it delivers to the BrickStore that it is made with.
 *
 * Every function may be called from any thread.
 */
class BrickProducer : public osg::Referenced
{
public:
    /** Have the bricks of a source made for the context of a visitor, unless they are made or on their way. Work on an
     * older source is given up.
     * @param waits return when the bricks are there for the frame that is being culled; false: they may come in a later
     * frame. */
    virtual void produce(const LegoSource& source, osgUtil::CullVisitor& visitor, bool waits) = 0;

    /** Deliver sets that have been finished since, and let go of what has been idle for a while. Called in every update
     * traversal, with the number of the frame. */
    virtual void update(unsigned int frame) = 0;

    /** Give up work that is under way: its source is gone. */
    virtual void cancel() = 0;

    virtual void resizeGLObjectBuffers(unsigned int maxSize) = 0;
    virtual void releaseGLObjects(osg::State* state) = 0;

protected:
    ~BrickProducer() override = default;
};

} // namespace osgLego
