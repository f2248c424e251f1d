#define GL_GLEXT_PROTOTYPES
#include "GlLedger.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

struct Target
{
    GLenum target;
    GLenum binding; //!< what to ask for its name by
};

constexpr std::array BUFFER_TARGETS{Target{GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
                                    Target{GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER_BINDING},
                                    Target{GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
                                    Target{GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING},
                                    Target{GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING},
                                    Target{GL_TEXTURE_BUFFER, GL_TEXTURE_BUFFER_BINDING},
                                    Target{GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING},
                                    Target{GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING},
                                    Target{GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING},
                                    Target{GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING}};

constexpr std::array TEXTURE_TARGETS{Target{GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
                                     Target{GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
                                     Target{GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
                                     Target{GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE},
                                     Target{GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
                                     Target{GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
                                     Target{GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
                                     Target{GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY}};

constexpr GLenum FIRST_FACE = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
constexpr GLenum LAST_FACE = GL_TEXTURE_CUBE_MAP_NEGATIVE_Z;

constexpr std::array<GLenum, 9> TEXEL_BITS{GL_TEXTURE_RED_SIZE,   GL_TEXTURE_GREEN_SIZE,     GL_TEXTURE_BLUE_SIZE,
                                           GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_INTENSITY_SIZE,
                                           GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE,   GL_TEXTURE_SHARED_SIZE};
constexpr std::array<GLenum, 6> RENDER_BUFFER_BITS{GL_RENDERBUFFER_RED_SIZE,   GL_RENDERBUFFER_GREEN_SIZE,
                                                   GL_RENDERBUFFER_BLUE_SIZE,  GL_RENDERBUFFER_ALPHA_SIZE,
                                                   GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE};

template <std::size_t SIZE>
GLint findName(const std::array<Target, SIZE>& targets, GLenum target)
{
    GLint name = 0;
    for (const Target& candidate : targets)
        if (candidate.target == target) glGetIntegerv(candidate.binding, &name);
    return name;
}

GLint askLevel(GLenum target, GLint level, GLenum what)
{
    GLint value = 0;
    glGetTexLevelParameteriv(target, level, what, &value);
    return value;
}

/** The bytes of one level; adds what it is to `description` if it is the first. */
std::size_t measureLevel(GLenum target, GLint level, std::string& description)
{
    const auto width = static_cast<std::size_t>(askLevel(target, level, GL_TEXTURE_WIDTH));
    const auto height = static_cast<std::size_t>(askLevel(target, level, GL_TEXTURE_HEIGHT));
    const auto depth = static_cast<std::size_t>(std::max(askLevel(target, level, GL_TEXTURE_DEPTH), 1));
    const auto samples = static_cast<std::size_t>(std::max(askLevel(target, level, GL_TEXTURE_SAMPLES), 1));
    std::size_t bits = 0;
    for (const GLenum channel : TEXEL_BITS)
        bits += static_cast<std::size_t>(askLevel(target, level, channel));
    if (width > 0 && description.empty())
        description = fmt::format("texture of {} x {}{}{}, {} bytes a texel", width, height,
                                  depth > 1 ? fmt::format(" x {}", depth) : "",
                                  samples > 1 ? fmt::format(", {} samples", samples) : "", bits / 8);
    return width * height * depth * samples * bits / 8;
}

/** All levels that there are. */
std::size_t measureLevels(GLenum target, std::string& description)
{
    std::size_t sum = 0;
    constexpr GLint MAXIMUM = 14; // the last level of 16384 pixels
    for (GLint level = 0; level <= MAXIMUM; ++level)
    {
        const std::size_t bytes = measureLevel(target, level, description);
        if (bytes == 0) break;
        sum += bytes;
    }
    return sum;
}

} // namespace

void GlLedger::note(Kind kind, GLint name, const Object& object)
{
    std::size_t& bytes = _objects[{kind, static_cast<GLuint>(name)}];
    _sum += object.bytes - bytes;
    bytes = object.bytes;
    _peak = std::max(_peak, _sum);
    if (object.bytes > _largest.bytes) _largest = object;
}

void GlLedger::noteBuffer(GLenum target, std::size_t bytes)
{
    note(Kind::BUFFER, findName(BUFFER_TARGETS, target), {bytes, "buffer"});
}

void GlLedger::noteTexture(GLenum target)
{
    const bool isFace = target >= FIRST_FACE && target <= LAST_FACE;
    const bool isCube = isFace || target == GL_TEXTURE_CUBE_MAP;
    const GLint name = findName(TEXTURE_TARGETS, isCube ? GL_TEXTURE_CUBE_MAP : target);
    if (name == 0) return; // a proxy, which only asks whether there would be room
    Object object;
    if (!isCube) object.bytes = measureLevels(target, object.description);
    for (GLenum face = FIRST_FACE; isCube && face <= LAST_FACE; ++face)
        object.bytes += measureLevels(face, object.description);
    note(Kind::TEXTURE, name, object);
}

void GlLedger::noteRenderBuffer()
{
    GLint name = 0;
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &name);
    const auto ask = [](GLenum what)
    {
        GLint value = 0;
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, what, &value);
        return static_cast<std::size_t>(value);
    };
    std::size_t bits = 0;
    for (const GLenum channel : RENDER_BUFFER_BITS)
        bits += ask(channel);
    const std::size_t width = ask(GL_RENDERBUFFER_WIDTH);
    const std::size_t height = ask(GL_RENDERBUFFER_HEIGHT);
    const std::size_t samples = std::max<std::size_t>(ask(GL_RENDERBUFFER_SAMPLES), 1);
    note(Kind::RENDER_BUFFER, name,
         {width * height * samples * bits / 8, fmt::format("render buffer of {} x {}", width, height)});
}

void GlLedger::forget(Kind kind, GLsizei number, const GLuint* names)
{
    for (GLsizei index = 0; index < number; ++index)
        if (const auto place = _objects.find({kind, names[index]}); place != _objects.end())
        {
            _sum -= place->second;
            _objects.erase(place);
        }
}

} // namespace osgLego
