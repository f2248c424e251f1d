#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/passes/SlabPlan.h>

#include <osg/State>

namespace osgLego
{

/** Which cells of a slab are covered, in a buffer on the GPU: a bit each, block by block, so that extraction need not
 * look at every cell. shaders/passes/occupancy.glsl says where the bit of a cell is.
 *
 * Blocks are as large as those of BrickBlock, and lie where these lie; a slab may begin and end inside of them.
 *
 * Every function but the constructor needs the context current in which the slab is voxelized.
 */
class Occupancy
{
public:
    static constexpr int WORDS_PER_BLOCK = 16;

    /** How many blocks a slab reaches into. */
    static int countBlocks(const BrickGrid& grid, const Slab& slab);

    /** Make room for so many blocks, all of their cells empty. Drivers that run out of memory say so by GL's error. */
    void clear(const osg::State& state, int numBlocks);

    /** Have the program that is applied mark what it covers, as shaders/passes/occupancy_marking.glsl does, until the
     * end. */
    void beginMarking(osg::State& state);
    void endMarking(osg::State& state) const;
    /** Whether it could: OpenGL 4.2, or the extension, is needed for it. */
    bool isMarked() const { return _isMarked; }

    GLuint getBuffer() const { return _buffer.get(); }
    /** The same as a buffer texture, a word in a texel. */
    GLuint getTexture() const { return _texture.get(); }

private:
    GlBuffer _buffer;
    GlTexture _texture;
    bool _isMarked = false;
};

} // namespace osgLego
