#pragma once

#include <osgLego/data/DistantOcclusion.h>
#include <osgLego/flattening/LegoSource.h>

#include <optional>

#include <osg/Referenced>
#include <osg/State>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The bricks that a frame needs. */
struct FrameNeeds
{
    double seconds = 0.0;                            //!< the longest time that it waits for them
    bool onlyDraft = false;                          //!< whether it waits no longer than for a draft
    bool neighbors = false;                          //!< whether it shows the occlusion by their neighbours
    std::optional<NearOcclusion> distantOcclusion{}; //!< the kind that it shows, if any
};

/** Makes an immutable brick set (BrickSet) from a source, and delivers it to the BrickStore given to its constructor.
 *
 * Every function may be called from any thread.
 */
class BrickProducer : public osg::Referenced
{
public:
    /** Make the bricks of a source for the context of a visitor, unless they exist or are being made. Cancels work on
     * an older source.
     * @param needs of the frame being culled. Bricks that are not ready in time follow in a later frame. */
    virtual void produce(const LegoSource& source, osgUtil::CullVisitor& visitor, const FrameNeeds& needs) = 0;

    /** Deliver the sets finished since the last call, and release resources that have been idle for a while. Called in
     * the update traversal of each frame while isBusy(), and possibly in others, with the number of the frame. */
    virtual void update(unsigned int frame) = 0;

    /** Whether update() has something to do in a later frame. */
    virtual bool isBusy() const = 0;

    /** Cancel work in progress, because there is no source any more. */
    virtual void cancel() = 0;

    virtual void resizeGLObjectBuffers(unsigned int maxSize) = 0;
    virtual void releaseGLObjects(osg::State* state) = 0;

protected:
    ~BrickProducer() override = default;
};

} // namespace osgLego
