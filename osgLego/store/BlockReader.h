#pragma once

#include <osgLego/data/BrickBlock.h>
#include <osgLego/gl/GlObject.h>

#include <vector>

#include <osg/GLExtensions>
#include <osg/State>

namespace osgLego
{

/** Finds the blocks of bricks that the passes wrote into a buffer, without ever waiting for the GPU: the points are
 * copied on the GPU, and read on the CPU in the first frame in which the copy is complete.
 *
 * Every function except stop() and forget() needs the context of the state current; one thread at a time.
 */
class BlockReader
{
public:
    /** Start to copy the first `numBricks` points (BrickPoint) of a buffer, and drop any copy in progress. */
    void start(const osg::State& state, GLuint buffer, GLsizei numBricks);
    /** Set `blocks` in the first call that finds the copy complete; other calls leave them unchanged. */
    void poll(const osg::State& state, std::vector<BrickBlock>& blocks);
    /** Drop any copy in progress. */
    void stop();
    /** Drop its fence as well, which the context then takes along: for a context that closes. */
    void forget();

private:
    void deleteFence(const osg::GLExtensions& extensions);

    GlBuffer _copy; // exists while a copy is in progress
    GLsizei _numBricks = 0;
    GLsync _fence = nullptr; // of the copy in progress, or of one that was dropped
};

} // namespace osgLego
