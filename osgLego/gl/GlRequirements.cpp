#include <osgLego/gl/GlRequirements.h>

#include <algorithm>
#include <iomanip>
#include <map>
#include <mutex>
#include <sstream>
#include <string_view>
#include <vector>

#include <osg/ContextData>

namespace osgLego
{

namespace
{

constexpr float NEEDED_VERSION = 4.0f;

struct Limit
{
    GLenum name;
    const char* text;
    GLint needed;
};

std::string joined(const std::vector<std::string>& items)
{
    std::string result;
    for (const std::string& item : items)
        result += (result.empty() ? "" : ", ") + item;
    return result;
}

/** The renderer of the current context. Software renderers, Mesa's and others, are recognised by their names. */
Renderer findRenderer()
{
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view name = text ? text : "";
    for (const char* software : {"llvmpipe", "softpipe", "Software", "SWR", "swrast", "SwiftShader", "GDI Generic"})
        if (name.find(software) != std::string_view::npos) return Renderer::SOFTWARE;
    return Renderer::HARDWARE;
}

/** The renderers of all contexts. */
class Renderers
{
public:
    void set(unsigned int contextID, Renderer renderer)
    {
        const std::lock_guard lock(_mutex);
        _renderers[contextID] = renderer;
    }

    Renderer get(unsigned int contextID) const
    {
        const std::lock_guard lock(_mutex);
        const auto found = _renderers.find(contextID);
        return found == _renderers.end() ? Renderer::UNKNOWN : found->second;
    }

private:
    mutable std::mutex _mutex;
    std::map<unsigned int, Renderer> _renderers;
};

Renderers& getRenderers()
{
    static Renderers renderers;
    return renderers;
}

bool isProfileCore()
{
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    return (profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
}

std::string findMissing(const osg::State& state)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    if (std::string version = GlRequirements::getMissingVersion(extensions); !version.empty()) return version;

    std::vector<std::string> missing;
    const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    const std::string here = std::string(" (found: ") + (version ? version : "none") + ")";
    const bool usesUniforms = state.getUseModelViewAndProjectionUniforms() && state.getUseVertexAttributeAliasing();
    if (isProfileCore() && !usesUniforms)
        return "in a context of the core profile, osg::State::setUseModelViewAndProjectionUniforms(true) and "
               "setUseVertexAttributeAliasing(true) are needed" +
               here;

    for (const Limit& limit :
         {Limit{GL_MAX_TEXTURE_SIZE, "GL_MAX_TEXTURE_SIZE", GlRequirements::TEXTURE_SIZE},
          Limit{GL_MAX_TEXTURE_BUFFER_SIZE, "GL_MAX_TEXTURE_BUFFER_SIZE", GlRequirements::BUFFER_TEXELS},
          Limit{GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS, "GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS", 1024},
          Limit{GL_MAX_GEOMETRY_SHADER_INVOCATIONS, "GL_MAX_GEOMETRY_SHADER_INVOCATIONS", 2}})
    {
        GLint value = 0;
        glGetIntegerv(limit.name, &value);
        if (value >= limit.needed) continue;
        std::ostringstream text;
        text << limit.text << " of " << limit.needed << " (found: " << value << ")";
        missing.push_back(text.str());
    }
    return missing.empty() ? std::string() : joined(missing) + " is needed" + here;
}

} // namespace

GlRequirements::GlRequirements(unsigned int) {}

const std::string& GlRequirements::getMissing(const osg::State& state)
{
    auto* requirements = osg::get<GlRequirements>(state.getContextID());
    if (!requirements->_checked)
    {
        requirements->_checked = true;
        requirements->_missing = findMissing(state);
        getRenderers().set(state.getContextID(), findRenderer());
    }
    return requirements->_missing;
}

bool GlRequirements::isCore(const osg::State& state)
{
    // The flag first: the look-up of the profile takes a lock.
    return state.getUseModelViewAndProjectionUniforms() && hasCoreProfile(state);
}

bool GlRequirements::hasCoreProfile(const osg::State& state)
{
    auto* requirements = osg::get<GlRequirements>(state.getContextID());
    if (!requirements->_hasCoreProfile) requirements->_hasCoreProfile = isProfileCore();
    return *requirements->_hasCoreProfile;
}

Renderer GlRequirements::getRenderer(unsigned int contextID)
{
    return getRenderers().get(contextID);
}

std::string GlRequirements::getMissingVersion(const osg::GLExtensions& extensions)
{
    // Both versions are parsed from text into floats, so they may be slightly too low.
    constexpr float SLACK = 0.01f;
    if (std::min(extensions.glVersion, extensions.glslLanguageVersion) > NEEDED_VERSION - SLACK) return {};
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << "OpenGL 4.0 or later with GLSL 4.00 is needed (found: OpenGL "
         << extensions.glVersion << std::setprecision(2) << " with GLSL " << extensions.glslLanguageVersion << ")";
    return text.str();
}

} // namespace osgLego
