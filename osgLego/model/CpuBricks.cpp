#include <osgLego/model/CpuBricks.h>

#include <osgLego/cpu/CpuVoxelizer.h>

#include <osg/Timer>

namespace osgLego
{

osg::ref_ptr<const BrickModel> makeBricksOnCpu(const LegoSource& source, CpuBricksWork& work)
{
    const osg::Timer_t start = osg::Timer::instance()->tick();
    const osg::ref_ptr<const BrickModel> cells =
        voxelizeOnCpu(*source.triangles, source.lookup.hasPalette() ? CellColor::DOMINANT : CellColor::MEAN);
    if (work.isCancelled && work.isCancelled()) return nullptr;
    work.statistics = {};
    work.statistics.isFromCpu = true;
    work.statistics.numTriangles = source.triangles->getNumTriangles();
    work.statistics.flattening = source.flattening;
    work.statistics.voxelization = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());

    ModelBuilder builder(source.settings, source.lookup);
    builder.setCancellation(work.isCancelled);
    builder.setProgress(work.progress);
    if (work.previous) builder.setPrevious(*work.previous);
    osg::ref_ptr<const BrickModel> bricks = builder.build(*cells);
    work.error = builder.getError();
    work.warning = builder.getWarning();
    work.measureLayout = builder.getMeasurement();
    return bricks;
}

} // namespace osgLego
