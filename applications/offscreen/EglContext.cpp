#include <offscreen/EglContext.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include <EGL/eglext.h>
#include <osg/GLDefines>

namespace osgLego
{

namespace
{

template <typename Function>
Function getFunction(const char* name)
{
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool isSoftware(EGLDeviceEXT device)
{
    const auto query = getFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    const char* extensions = query ? query(device, EGL_EXTENSIONS) : nullptr;
    return extensions && std::strstr(extensions, "EGL_MESA_device_software");
}

/** The displays to try, in order: GPUs, Mesa's surfaceless platform, software devices, the default display.
 * @param softwareFirst software devices before the surfaceless platform. */
std::vector<EGLDisplay> findDisplays(bool softwareFirst)
{
    std::vector<EGLDisplay> displays;
    std::vector<EGLDisplay> softwareDisplays;
    const auto getDisplay = getFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    const auto queryDevices = getFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    if (getDisplay && queryDevices)
    {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count))
            for (EGLint index = 0; index < count; ++index)
            {
                EGLDeviceEXT device = devices[static_cast<std::size_t>(index)];
                (isSoftware(device) ? softwareDisplays : displays)
                    .push_back(getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
            }
    }
    displays.push_back(getDisplay ? getDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr) : EGL_NO_DISPLAY);
    displays.insert(softwareFirst ? displays.end() - 1 : displays.end(), softwareDisplays.begin(),
                    softwareDisplays.end());
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

// clang-format off
constexpr std::array COMPATIBLE{EGL_CONTEXT_MAJOR_VERSION,       4,
                                EGL_CONTEXT_MINOR_VERSION,       0,
                                EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                EGL_NONE};
constexpr std::array ANY{EGL_NONE};
// clang-format on

/** The attributes of a context of the core profile, of the version in `traits`. */
std::array<EGLint, 7> getCoreAttributes(const osg::GraphicsContext::Traits& traits)
{
    unsigned int major = 0;
    unsigned int minor = 0;
    traits.getContextVersion(major, minor);
    return {EGL_CONTEXT_MAJOR_VERSION,
            static_cast<EGLint>(major),
            EGL_CONTEXT_MINOR_VERSION,
            static_cast<EGLint>(minor),
            EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
            EGL_NONE};
}

} // namespace

EglContext::EglContext(Traits* traits)
{
    _traits = traits;
    setState(new osg::State);
    getState()->setGraphicsContext(this);
    if (traits->sharedContext.valid())
    {
        getState()->setContextID(traits->sharedContext->getState()->getContextID());
        incrementContextIDUsageCount(getState()->getContextID());
    }
    else
    {
        getState()->setContextID(createNewContextID());
    }
}

EglContext::~EglContext()
{
    close(true);
}

bool EglContext::realizeImplementation()
{
    // osgViewer realizes its contexts more than once.
    if (isRealizedImplementation()) return true;
    _error = "there is no EGL display that gives an OpenGL context";
    const std::vector<EGLDisplay> displays = findDisplays(_traits->displayNum != 0);
    if (_traits->glContextProfileMask & GL_CONTEXT_CORE_PROFILE_BIT)
    {
        const std::array<EGLint, 7> core = getCoreAttributes(*_traits);
        return std::ranges::any_of(displays, [&](EGLDisplay display)
                                   { return display != EGL_NO_DISPLAY && realizeOn(display, core.data()); });
    }
    // Accept an older version only after every display has been tried: the library's message about the version of such
    // a context is clearer than EGL's.
    for (const EGLint* attributes : {COMPATIBLE.data(), ANY.data()})
        for (EGLDisplay display : displays)
            if (display != EGL_NO_DISPLAY && realizeOn(display, attributes)) return true;
    return false;
}

bool EglContext::realizeOn(EGLDisplay display, const EGLint* attributes)
{
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) return false;

    // clang-format off
    const std::array wanted{EGL_SURFACE_TYPE,    EGL_PBUFFER_BIT,
                            EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                            EGL_RED_SIZE,        8,
                            EGL_GREEN_SIZE,      8,
                            EGL_BLUE_SIZE,       8,
                            EGL_ALPHA_SIZE,      static_cast<EGLint>(_traits->alpha),
                            EGL_DEPTH_SIZE,      static_cast<EGLint>(_traits->depth),
                            EGL_STENCIL_SIZE,    static_cast<EGLint>(_traits->stencil),
                            EGL_NONE};
    // clang-format on
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) return false;

    const auto* shared = dynamic_cast<EglContext*>(_traits->sharedContext.get());
    const std::array size{EGL_WIDTH, _traits->width, EGL_HEIGHT, _traits->height, EGL_NONE};
    _surface = eglCreatePbufferSurface(display, config, size.data());
    _context = eglCreateContext(display, config, shared ? shared->_context : EGL_NO_CONTEXT, attributes);
    _display = display;
    if (_surface != EGL_NO_SURFACE && _context != EGL_NO_CONTEXT) return true;
    closeImplementation();
    return false;
}

void EglContext::closeImplementation()
{
    if (_display == EGL_NO_DISPLAY) return;
    if (_context != EGL_NO_CONTEXT && eglGetCurrentContext() == _context) releaseContextImplementation();
    if (_context != EGL_NO_CONTEXT) eglDestroyContext(_display, _context);
    if (_surface != EGL_NO_SURFACE) eglDestroySurface(_display, _surface);
    _context = EGL_NO_CONTEXT;
    _surface = EGL_NO_SURFACE;
    _display = EGL_NO_DISPLAY;
}

bool EglContext::makeCurrentImplementation()
{
    // EGL binds an API per thread.
    return isRealizedImplementation() && eglBindAPI(EGL_OPENGL_API) &&
           eglMakeCurrent(_display, _surface, _surface, _context);
}

bool EglContext::makeContextCurrentImplementation(osg::GraphicsContext*)
{
    return makeCurrentImplementation();
}

bool EglContext::releaseContextImplementation()
{
    return eglMakeCurrent(_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

} // namespace osgLego
