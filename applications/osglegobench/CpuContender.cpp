#include "CpuContender.h"

#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/data/BrickPoints.h>

#include <osg/Timer>

namespace osgLego
{

std::string CpuContender::prepare(const BenchMesh& mesh, osg::GraphicsContext& context)
{
    _triangles = mesh.triangles;
    _buffer.prepare(context);
    return {};
}

double CpuContender::run()
{
    _bricks = nullptr; // letting go of the last ones is no part of making new ones
    const osg::Timer& timer = *osg::Timer::instance();
    const osg::Timer_t start = timer.tick();
    _bricks = voxelizeOnCpu(*_triangles);
    const osg::Timer_t middle = timer.tick();
    _buffer.upload(createBrickPoints(*_bricks).points);
    const osg::Timer_t end = timer.tick();
    _legolization = timer.delta_m(start, middle);
    _points = timer.delta_m(middle, end);
    return _legolization + _points;
}

void CpuContender::release()
{
    _buffer.release();
    _bricks = nullptr;
    _triangles = nullptr;
}

std::vector<std::pair<std::string, double>> CpuContender::getStageTimes() const
{
    return {{"legolization", _legolization}, {"points", _points}};
}

} // namespace osgLego
