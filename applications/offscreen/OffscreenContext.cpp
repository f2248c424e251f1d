#include <offscreen/OffscreenContext.h>

#include <osg/GLExtensions>

#if defined(OSGLEGO_OSMESA)
#include <offscreen/OsMesaContext.h>
#else
#include <offscreen/EglContext.h>
#endif

namespace osgLego
{

#if defined(OSGLEGO_OSMESA)
using OffscreenContext = OsMesaContext;
#else
using OffscreenContext = EglContext;
#endif

namespace
{

/** OSG assumes that a GL function is supported if a library exports its name, but libGL and libOSMesa export all names.
 * OSG would call this function for every multisampled frame buffer object; without the extension the function does
 * nothing. */
void forgetDeadFunctions(osg::GraphicsContext& context)
{
    if (!context.makeCurrent()) return;
    const unsigned int contextID = context.getState()->getContextID();
    if (!osg::isGLExtensionSupported(contextID, "GL_NV_framebuffer_multisample_coverage"))
        context.getState()->get<osg::GLExtensions>()->glRenderbufferStorageMultisampleCoverageNV = nullptr;
    context.releaseContext();
}

} // namespace

osg::ref_ptr<osg::GraphicsContext> createOffscreenContext(int width, int height, std::string& error, int display,
                                                          const std::string& coreVersion)
{
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    traits->displayNum = display;
    traits->width = width;
    traits->height = height;
    traits->red = traits->green = traits->blue = traits->alpha = 8;
    traits->depth = 24;
    traits->stencil = 8;
    traits->pbuffer = true;
    traits->doubleBuffer = false;

    if (!coreVersion.empty())
    {
        traits->glContextProfileMask = GL_CONTEXT_CORE_PROFILE_BIT;
        traits->glContextVersion = coreVersion;
    }

    osg::ref_ptr<OffscreenContext> context = new OffscreenContext(traits);
    if (!context->realize())
    {
        error = context->getError();
        return nullptr;
    }
    forgetDeadFunctions(*context);
    return context;
}

} // namespace osgLego
