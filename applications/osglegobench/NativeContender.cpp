#include "NativeContender.h"

#include <osg/Timer>

namespace osgLego
{

std::string NativeContender::prepare(const BenchMesh& mesh, osg::GraphicsContext& context)
{
    _triangles = mesh.triangles;
    _context = &context;
    _buffer = GlBuffer(*context.getState());
    return {};
}

double NativeContender::run()
{
    _bricks = nullptr; // releasing the previous bricks is not part of finding new ones
    const osg::GLExtensions& extensions = *_context->getState()->get<osg::GLExtensions>();
    const osg::Timer& timer = *osg::Timer::instance();
    const osg::Timer_t start = timer.tick();
    _bricks = findCells();
    const osg::Timer_t middle = timer.tick();
    const std::vector<BrickPoint> points = createPoints();
    extensions.glBindBuffer(GL_ARRAY_BUFFER, _buffer.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(BrickPoint)), points.data(),
                            GL_STATIC_DRAW);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
    glFinish();
    const osg::Timer_t end = timer.tick();
    _cellsTime = timer.delta_m(start, middle);
    _pointsTime = timer.delta_m(middle, end);
    return _cellsTime + _pointsTime;
}

void NativeContender::release()
{
    _buffer = GlBuffer();
    _bricks = nullptr;
    _triangles = nullptr;
    _context = nullptr;
}

} // namespace osgLego
