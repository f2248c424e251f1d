#pragma once

#include <osgLego/data/BrickBlock.h>
#include <osgLego/gl/GlObject.h>

#include <vector>

#include <osg/GLExtensions>
#include <osg/State>

namespace osgLego
{

/** Learns the blocks of bricks that the passes wrote into a buffer, without ever waiting for the GPU: the points are
 * copied on the GPU, and looked at on the CPU in the first frame that finds the copy complete.
 *
 * Every function but stop() needs the context of the state current; one thread at a time.
 */
class BlockReader
{
public:
    /** Begin for so many points (BrickPoint) at the start of a buffer, in place of any copy that is under way. */
    void start(const osg::State& state, GLuint buffer, GLsizei numBricks);
    /** Fill in the blocks once the copy is complete; leave them alone before, after, and where nothing was started. */
    void poll(const osg::State& state, std::vector<BrickBlock>& blocks);
    /** Forget a copy that is under way. */
    void stop();

private:
    GlBuffer _copy; // there is one while a copy is under way
    GLsizei _numBricks = 0;
    GLsync _fence = nullptr;
};

} // namespace osgLego
