#pragma once

#include <optional>
#include <string>

#include <osg/GLExtensions>
#include <osg/Referenced>
#include <osg/State>

namespace osgLego
{

/** The kind of renderer that draws in a context. */
enum class Renderer
{
    UNKNOWN, //!< the context has not been checked yet
    SOFTWARE,
    HARDWARE
};

/** The requirements of the passes on a GL context, checked once for each context ID.
 *
 * They are OpenGL 4.0, GLSL 4.00, in the core profile an osg::State that uses uniforms for matrices, two geometry
 * shader invocations, 1024 output components of a geometry shader, and textures and buffer textures as large as the
 * passes create. Image stores in fragment shaders (OpenGL 4.2) are used where available, but not required.
 */
class GlRequirements : public osg::Referenced
{
public:
    static constexpr int TEXTURE_SIZE = 4096;     //!< along a side, in texels
    static constexpr int BUFFER_TEXELS = 6 << 20; //!< of a buffer texture

    explicit GlRequirements(unsigned int contextID);

    /** The requirements that the context of `state`, which must be current, does not meet, in one sentence; empty if it
     * meets all. */
    static const std::string& getMissing(const osg::State& state);

    /** The same, but checks only the version, so that the context need not be current. */
    static std::string getMissingVersion(const osg::GLExtensions& extensions);

    /** Whether the context of `state` has the core profile, and the state uses uniforms for matrices, without which a
     * core context does not meet the requirements. The context must be current. */
    static bool isCore(const osg::State& state);
    /** Whether the context of `state` has the core profile. The context must be current. */
    static bool hasCoreProfile(const osg::State& state);

    /** The renderer of a context, as found by getMissing(). May be called from any thread. */
    static Renderer getRenderer(unsigned int contextID);

private:
    ~GlRequirements() override = default;

    bool _checked = false;
    std::optional<bool> _hasCoreProfile;
    std::string _missing;
};

} // namespace osgLego
