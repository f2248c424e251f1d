#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>

#include <osg/GL>
#include <osg/GLExtensions>

namespace osgLego
{

/** Feeds buffers of GridVertex to the attribute locations 0 to 3 of a vertex shader during its lifetime; or, without
 * colours, its position and triangle to the locations 0 and 1.
 *
 * No vertex array may be enabled and no array buffer bound before, and none is afterwards. Needs its context current.
 */
class GridVertexArrays
{
public:
    /** The size of a vertex that ends after its triangle. */
    static constexpr GLsizei BYTES_WITHOUT_COLORS = offsetof(GridVertex, coordinate);

    explicit GridVertexArrays(const osg::GLExtensions& extensions, bool hasColors = true);
    ~GridVertexArrays();
    GridVertexArrays(const GridVertexArrays&) = delete;
    GridVertexArrays& operator=(const GridVertexArrays&) = delete;

    /** Read the vertices of the following draw calls from `buffer`. @param stride the size of a vertex in it. */
    void bind(GLuint buffer, GLsizei stride = sizeof(GridVertex)) const;

private:
    const osg::GLExtensions& _extensions;
    GLuint _numAttributes;
};

} // namespace osgLego
