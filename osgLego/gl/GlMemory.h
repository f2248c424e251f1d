#pragma once

#include <osg/GL>

namespace osgLego
{

/** Whether GL has run out of memory since its errors were last read. Clears all errors; needs a current context. */
inline bool takeOutOfMemoryError()
{
    bool result = false;
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
        result = result || error == GL_OUT_OF_MEMORY;
    return result;
}

} // namespace osgLego
