#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/BrickNeighbors.h>
#include <osgLego/gl/GlObject.h>

#include <span>

#include <osg/Referenced>
#include <osg/State>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** The neighbours of bricks in a buffer of a context, and the tables of the light that they and studs hide
 * (createOcclusionTable, createStudOcclusion), as textures for shaders/polygonization/grid_occlusion.glsl. */
class GridOcclusionTextures : public osg::Referenced
{
public:
    /** Use neighbours that are in a buffer. Needs the context of the state current. */
    GridOcclusionTextures(const osg::State& state, const BrickGrid& grid, GlBuffer&& neighbors, GLsizei count);
    /** Upload neighbours. Needs the context of the state current; the caller checks for lack of memory. */
    GridOcclusionTextures(const osg::State& state, const BrickGrid& grid, std::span<const BrickNeighbors> neighbors);

    GLuint getNeighbors() const { return _neighbors.get(); }
    /** The buffer of this texture, of BrickNeighbors. */
    GLuint getBuffer() const { return _buffer.get(); }
    /** The number of bricks whose neighbours are known. */
    GLsizei getCount() const { return _count; }
    /** The table, which all nodes share whose cells have the same proportions. */
    osg::Texture2D& getTable() const { return *_table; }
    /** The table of createStudOcclusion, which they share, too. */
    osg::Texture2D& getStuds() const { return *_studs; }

private:
    ~GridOcclusionTextures() override = default;

    GlBuffer _buffer;
    GlTexture _neighbors;
    GLsizei _count;
    osg::ref_ptr<osg::Texture2D> _table;
    osg::ref_ptr<osg::Texture2D> _studs;
};

} // namespace osgLego
