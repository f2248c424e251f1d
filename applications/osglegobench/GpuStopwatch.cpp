#include "GpuStopwatch.h"

#include "BenchEnvironment.h"

#include <osg/GLExtensions>

namespace osgLego
{

void GpuStopwatch::prepare(osg::GraphicsContext& context)
{
    release();
    osg::GLExtensions* extensions = osg::GLExtensions::Get(context.getState()->getContextID(), true);
    if (!extensions->isARBTimerQuerySupported || BenchEnvironment::find(context).isSoftware()) return;
    _extensions = extensions;
    _extensions->glGenQueries(2, _queries);
}

void GpuStopwatch::start() const
{
    if (_extensions) _extensions->glQueryCounter(_queries[0], GL_TIMESTAMP);
}

void GpuStopwatch::stop() const
{
    if (_extensions) _extensions->glQueryCounter(_queries[1], GL_TIMESTAMP);
}

std::optional<double> GpuStopwatch::getTime() const
{
    if (!_extensions) return std::nullopt;
    GLuint64 times[2] = {0, 0};
    for (int end = 0; end < 2; ++end)
        _extensions->glGetQueryObjectui64v(_queries[end], GL_QUERY_RESULT, &times[end]);
    return 1e-6 * static_cast<double>(times[1] - times[0]);
}

void GpuStopwatch::release()
{
    if (_extensions) _extensions->glDeleteQueries(2, _queries);
    _extensions = nullptr;
}

} // namespace osgLego
