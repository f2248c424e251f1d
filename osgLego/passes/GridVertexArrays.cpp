#include <osgLego/passes/GridVertexArrays.h>

#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>

namespace osgLego
{

namespace
{

constexpr GLuint NUM_ATTRIBUTES = 4;
constexpr GLsizei STRIDE = sizeof(GridVertex);

const void* offsetOf(std::size_t offset)
{
    return reinterpret_cast<const void*>(offset);
}

} // namespace

GridVertexArrays::GridVertexArrays(const osg::GLExtensions& extensions) : _extensions(extensions)
{
    for (GLuint attribute = 0; attribute < NUM_ATTRIBUTES; ++attribute)
        _extensions.glEnableVertexAttribArray(attribute);
}

GridVertexArrays::~GridVertexArrays()
{
    for (GLuint attribute = 0; attribute < NUM_ATTRIBUTES; ++attribute)
        _extensions.glDisableVertexAttribArray(attribute);
    _extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void GridVertexArrays::bind(GLuint buffer) const
{
    _extensions.glBindBuffer(GL_ARRAY_BUFFER, buffer);
    _extensions.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, STRIDE, offsetOf(offsetof(GridVertex, position)));
    _extensions.glVertexAttribIPointer(1, 1, GL_UNSIGNED_INT, STRIDE, offsetOf(offsetof(GridVertex, triangle)));
    _extensions.glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, STRIDE, offsetOf(offsetof(GridVertex, coordinate)));
    _extensions.glVertexAttribIPointer(3, 2, GL_UNSIGNED_INT, STRIDE, offsetOf(offsetof(GridVertex, colorAndLevel)));
}

} // namespace osgLego
