#include "BrickPointBuffer.h"

#include <osg/GLExtensions>

namespace osgLego
{

void BrickPointBuffer::prepare(osg::GraphicsContext& context)
{
    release();
    _extensions = osg::GLExtensions::Get(context.getState()->getContextID(), true);
    _extensions->glGenBuffers(1, &_name);
}

void BrickPointBuffer::upload(const std::vector<BrickPoint>& points) const
{
    _extensions->glBindBuffer(GL_ARRAY_BUFFER, _name);
    _extensions->glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(BrickPoint)),
                              points.data(), GL_STATIC_DRAW);
    _extensions->glBindBuffer(GL_ARRAY_BUFFER, 0);
    glFinish();
}

void BrickPointBuffer::release()
{
    if (_name != 0) _extensions->glDeleteBuffers(1, &_name);
    _name = 0;
}

} // namespace osgLego
