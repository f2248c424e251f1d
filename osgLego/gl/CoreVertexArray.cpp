#include <osgLego/gl/CoreVertexArray.h>

#include <osgLego/gl/GlRequirements.h>

namespace osgLego
{

CoreVertexArray::CoreVertexArray(const osg::State& state)
{
    if (!GlRequirements::isCore(state)) return;
    _extensions = state.get<osg::GLExtensions>();
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &_previous);
    _extensions->glGenVertexArrays(1, &_name);
    _extensions->glBindVertexArray(_name);
}

CoreVertexArray::~CoreVertexArray()
{
    if (!_extensions) return;
    _extensions->glBindVertexArray(static_cast<GLuint>(_previous));
    _extensions->glDeleteVertexArrays(1, &_name);
}

} // namespace osgLego
