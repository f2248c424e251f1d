#pragma once

#include <string>

#include <osg/GLExtensions>
#include <osg/Referenced>
#include <osg/State>

namespace osgLego
{

/** What draws in a context. */
enum class Renderer
{
    UNKNOWN, //!< the context has not been asked yet
    SOFTWARE,
    HARDWARE
};

/** What the passes need of a GL context, checked once for each context ID.
 *
 * OpenGL 4.0 in the compatibility profile (OSG's fixed-function state and geometry shaders side by side), GLSL 4.00,
 * two geometry shader invocations, 1024 components out of a geometry shader, and buffer textures and textures as large
 * as the passes make them. Images that fragments write into (OpenGL 4.2) are used where they are, and not needed.
 */
class GlRequirements : public osg::Referenced
{
public:
    static constexpr int TEXTURE_SIZE = 4096;     //!< along a side, in texels
    static constexpr int BUFFER_TEXELS = 6 << 20; //!< of a buffer texture

    explicit GlRequirements(unsigned int contextID);

    /** What the current context lacks, in one sentence that begins with what is needed; empty if nothing.
     *
     * Call with the context of `state` current. */
    static const std::string& getMissing(const osg::State& state);

    /** The same as far as it can be told by the version alone, for which the context need not be current. */
    static std::string getMissingVersion(const osg::GLExtensions& extensions);

    /** What draws in a context, as it was found by the last getMissing() in it. May be called from any thread. */
    static Renderer getRenderer(unsigned int contextID);

private:
    ~GlRequirements() override = default;

    bool _checked = false;
    std::string _missing;
};

} // namespace osgLego
