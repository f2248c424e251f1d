#include <osgLego/gl/TransformFeedback.h>

namespace osgLego
{

TransformFeedback::TransformFeedback(const osg::GLExtensions& extensions) : _extensions(extensions)
{
    _extensions.glGenTransformFeedbacks(1, &_name);
    _extensions.glGenQueries(2, _queries);
}

TransformFeedback::~TransformFeedback()
{
    _extensions.glDeleteQueries(2, _queries);
    _extensions.glDeleteTransformFeedbacks(1, &_name);
}

void TransformFeedback::begin(GLenum primitives, GLuint buffer, GLintptr offset, GLsizeiptr size)
{
    _extensions.glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, _name);
    _extensions.glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer, offset, size);
    glEnable(GL_RASTERIZER_DISCARD);
    _extensions.glBeginQuery(GL_PRIMITIVES_GENERATED, _queries[0]);
    _extensions.glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, _queries[1]);
    _extensions.glBeginTransformFeedback(primitives);
}

void TransformFeedback::end()
{
    _extensions.glEndTransformFeedback();
    _extensions.glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    _extensions.glEndQuery(GL_PRIMITIVES_GENERATED);
    glDisable(GL_RASTERIZER_DISCARD);
    _extensions.glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    _extensions.glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
}

void TransformFeedback::draw(GLenum primitives) const
{
    _extensions.glDrawTransformFeedback(primitives, _name);
}

CapturedPrimitives TransformFeedback::getResult() const
{
    CapturedPrimitives result;
    _extensions.glGetQueryObjectuiv(_queries[0], GL_QUERY_RESULT, &result.generated);
    _extensions.glGetQueryObjectuiv(_queries[1], GL_QUERY_RESULT, &result.written);
    return result;
}

} // namespace osgLego
