#include <offscreen/OffscreenContext.h>

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

osg::ref_ptr<osg::GraphicsContext> createOffscreenContext(int width, int height, std::string& error)
{
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    traits->width = width;
    traits->height = height;
    traits->red = traits->green = traits->blue = traits->alpha = 8;
    traits->depth = 24;
    traits->stencil = 8;
    traits->pbuffer = true;
    traits->doubleBuffer = false;

    osg::ref_ptr<OffscreenContext> context = new OffscreenContext(traits);
    if (context->realize()) return context;
    error = context->getError();
    return nullptr;
}

} // namespace osgLego
