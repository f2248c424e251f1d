#include <osgLego/passes/GridVertexArrays.h>

namespace osgLego
{

namespace
{

const void* offsetOf(std::size_t offset)
{
    return reinterpret_cast<const void*>(offset);
}

} // namespace

GridVertexArrays::GridVertexArrays(const osg::GLExtensions& extensions, bool hasColors) :
    _extensions(extensions), _numAttributes(hasColors ? 4 : 2)
{
    for (GLuint attribute = 0; attribute < _numAttributes; ++attribute)
        _extensions.glEnableVertexAttribArray(attribute);
}

GridVertexArrays::~GridVertexArrays()
{
    for (GLuint attribute = 0; attribute < _numAttributes; ++attribute)
        _extensions.glDisableVertexAttribArray(attribute);
    _extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void GridVertexArrays::bind(GLuint buffer, GLsizei stride) const
{
    _extensions.glBindBuffer(GL_ARRAY_BUFFER, buffer);
    _extensions.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offsetOf(offsetof(GridVertex, position)));
    _extensions.glVertexAttribIPointer(1, 1, GL_UNSIGNED_INT, stride, offsetOf(offsetof(GridVertex, triangle)));
    if (_numAttributes == 2) return;
    _extensions.glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride, offsetOf(offsetof(GridVertex, coordinate)));
    _extensions.glVertexAttribIPointer(3, 2, GL_UNSIGNED_INT, stride, offsetOf(offsetof(GridVertex, colorAndLevel)));
}

} // namespace osgLego
