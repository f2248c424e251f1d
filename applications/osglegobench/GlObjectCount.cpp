#include "GlObjectCount.h"

#include <stdexcept>

#include <osg/GL>
#include <osg/GLExtensions>
#include <osg/Texture>

namespace osgLego
{

namespace
{

using GetBufferParameter = void GL_APIENTRY(GLuint buffer, GLenum name, GLint* value);
using GetLevelParameter = void GL_APIENTRY(GLuint texture, GLint level, GLenum name, GLint* value);
using IsObject = GLboolean GL_APIENTRY(GLuint name);

// Drivers number objects from 1 on, and reuse the numbers of deleted ones.
constexpr GLuint MOST_OBJECTS = 1u << 17;

template <typename Function>
Function* findFunction(const char* name)
{
    void* const function = osg::getGLExtensionFuncPtr(name);
    if (!function) throw std::runtime_error(std::string("GL lacks ") + name + "; expected GL 4.5");
    return reinterpret_cast<Function*>(function);
}

double measureLevel(GetLevelParameter* getParameter, GLuint texture, GLint level)
{
    const auto get = [=](GLenum name)
    {
        GLint value = 0;
        getParameter(texture, level, name, &value);
        return static_cast<double>(value);
    };
    double bits = 0.0;
    for (const GLenum channel : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                 GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE})
        bits += get(channel);
    return get(GL_TEXTURE_WIDTH) * get(GL_TEXTURE_HEIGHT) * get(GL_TEXTURE_DEPTH) * bits / 8.0;
}

/** The bytes of all levels; 0 for a texture that shows a buffer. */
double measureTexture(GetLevelParameter* getParameter, GLuint texture)
{
    GLint buffer = 0;
    getParameter(texture, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &buffer);
    constexpr GLint MOST_LEVELS = 15;
    double bytes = 0.0;
    for (GLint level = 0; buffer == 0 && level < MOST_LEVELS; ++level)
    {
        const double added = measureLevel(getParameter, texture, level);
        if (added == 0.0) break;
        bytes += added;
    }
    while (glGetError() != GL_NO_ERROR) // of targets that have no such level
        ;
    return bytes;
}

} // namespace

GlObjectCount GlObjectCount::count()
{
    auto* const isBuffer = findFunction<IsObject>("glIsBuffer");
    auto* const isProgram = findFunction<IsObject>("glIsProgram");
    auto* const getBuffer = findFunction<GetBufferParameter>("glGetNamedBufferParameteriv");
    auto* const getLevel = findFunction<GetLevelParameter>("glGetTextureLevelParameteriv");
    GlObjectCount found;
    for (GLuint name = 1; name < MOST_OBJECTS; ++name)
    {
        if (isBuffer(name))
        {
            GLint size = 0;
            getBuffer(name, GL_BUFFER_SIZE, &size);
            ++found.numBuffers;
            found.bufferBytes += size;
        }
        if (glIsTexture(name))
        {
            ++found.numTextures;
            found.textureBytes += measureTexture(getLevel, name);
        }
        if (isProgram(name)) ++found.numPrograms;
    }
    return found;
}

} // namespace osgLego
