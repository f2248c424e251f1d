#include <offscreen/OsMesaContext.h>

#include <array>

namespace osgLego
{

OsMesaContext::OsMesaContext(Traits* traits)
{
    _traits = traits;
    setState(new osg::State);
    getState()->setGraphicsContext(this);
    getState()->setContextID(createNewContextID());
}

OsMesaContext::~OsMesaContext()
{
    close(true);
}

bool OsMesaContext::realizeImplementation()
{
    // osgViewer realizes its contexts more than once.
    if (isRealizedImplementation()) return true;
    // Without a version, OSMesa creates a context of OpenGL 1.
    // clang-format off
    const std::array attributes{OSMESA_FORMAT,                OSMESA_RGBA,
                                OSMESA_DEPTH_BITS,            static_cast<int>(_traits->depth),
                                OSMESA_STENCIL_BITS,          static_cast<int>(_traits->stencil),
                                OSMESA_PROFILE,               OSMESA_COMPAT_PROFILE,
                                OSMESA_CONTEXT_MAJOR_VERSION, 3,
                                OSMESA_CONTEXT_MINOR_VERSION, 0,
                                0};
    // clang-format on
    _context = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    if (!_context)
    {
        _error = "OSMesa gives no OpenGL context";
        return false;
    }
    _pixels.resize(4 * static_cast<std::size_t>(_traits->width) * static_cast<std::size_t>(_traits->height));
    return true;
}

void OsMesaContext::closeImplementation()
{
    if (_context) OSMesaDestroyContext(_context);
    _context = nullptr;
}

bool OsMesaContext::makeCurrentImplementation()
{
    return _context && OSMesaMakeCurrent(_context, _pixels.data(), GL_UNSIGNED_BYTE, _traits->width, _traits->height);
}

bool OsMesaContext::makeContextCurrentImplementation(osg::GraphicsContext*)
{
    return makeCurrentImplementation();
}

bool OsMesaContext::releaseContextImplementation()
{
    return OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
}

} // namespace osgLego
