#pragma once

#include <osgLego/data/BrickPoints.h>
#include <osgLego/gl/GlObject.h>

#include <functional>
#include <span>

#include <osg/GLExtensions>
#include <osg/State>

namespace osgLego
{

/** Reads the bricks that the passes wrote into a buffer, without waiting for the GPU unless told to: the points are
 * copied on the GPU, and read on the CPU in the first frame in which the copy is complete.
 *
 * Every function except stop() and forget() needs the context of the state current; one thread at a time.
 */
class BlockReader
{
public:
    /** Start to copy the first `numBricks` points (BrickPoint) of a buffer, and drop any copy in progress. */
    void start(const osg::State& state, GLuint buffer, GLsizei numBricks);
    bool isReading() const { return _numBricks > 0; }
    /** Call `use` with the points in the first call that finds the copy complete.
     * @param waits wait for the copy. */
    void poll(const osg::State& state, bool waits, const std::function<void(std::span<const BrickPoint>)>& use);
    /** Drop any copy in progress. */
    void stop();
    /** Drop the copy without deleting its fence, for a context that closes and so deletes it. */
    void forget();

private:
    void deleteFence(const osg::GLExtensions& extensions);

    GlBuffer _copy; // exists while a copy is in progress
    GLsizei _numBricks = 0;
    GLsync _fence = nullptr; // of the copy in progress, or of one that was dropped
};

} // namespace osgLego
