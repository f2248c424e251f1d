#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <GL/gl.h>

namespace osgLego
{

/** The bytes of buffers, textures and render buffers of one GL context, noted as they are made and deleted.
 *
 * Those of textures are what GL says of their texels; how a driver pads and compresses them is its secret. The window's
 * own frame buffer has no part in it. Functions need the context current, and only ask. */
class GlLedger
{
public:
    enum class Kind
    {
        BUFFER,
        TEXTURE,
        RENDER_BUFFER
    };

    /** Something that GL keeps. */
    struct Object
    {
        std::size_t bytes = 0;
        std::string description;
    };

    /** The buffer bound to a target was given room. */
    void noteBuffer(GLenum target, std::size_t bytes);
    /** The texture bound to a target was given room. */
    void noteTexture(GLenum target);
    /** The render buffer that is bound was given room. */
    void noteRenderBuffer();
    void forget(Kind kind, GLsizei number, const GLuint* names);

    /** The most bytes that there ever were at once. */
    std::size_t getPeak() const { return _peak; }
    /** The largest that there ever was. */
    const Object& getLargest() const { return _largest; }

private:
    void note(Kind kind, GLint name, const Object& object);

    std::map<std::pair<Kind, GLuint>, std::size_t> _objects;
    std::size_t _sum = 0;
    std::size_t _peak = 0;
    Object _largest;
};

} // namespace osgLego
