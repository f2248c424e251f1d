#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/passes/SlabPlan.h>

#include <osg/State>

namespace osgLego
{

/** A buffer on the GPU with one bit for each cell of a slab, set if the cell is covered, so that extraction need not
 * examine every cell. shaders/passes/occupancy.glsl defines the position of each bit.
 *
 * The bits are stored block by block. Blocks have the size and the positions of those of BrickBlock; a slab may begin
 * or end inside a block.
 *
 * Every function except the constructor needs the context current in which the slab is voxelized.
 */
class Occupancy
{
public:
    static constexpr int WORDS_PER_BLOCK = 16;

    /** The number of blocks that a slab reaches into. */
    static int countBlocks(const BrickGrid& grid, const Slab& slab);

    /** Allocate `numBlocks` blocks, with all cells empty. If memory runs out, GL reports an error. */
    void clear(const osg::State& state, int numBlocks);

    /** Let the applied program mark the cells that it covers, by shaders/passes/occupancy_marking.glsl, until
     * endMarking(). */
    void beginMarking(osg::State& state);
    void endMarking(osg::State& state) const;
    /** Whether the program could mark cells, which takes OpenGL 4.2 or GL_ARB_shader_image_load_store. */
    bool isMarked() const { return _isMarked; }

    GLuint getBuffer() const { return _buffer.get(); }
    /** The same buffer as a buffer texture, one word per texel. */
    GLuint getTexture() const { return _texture.get(); }

private:
    GlBuffer _buffer;
    GlTexture _texture;
    bool _isMarked = false;
};

} // namespace osgLego
