#include <osgLego/CpuLegolizer.h>

#include <osgLego/flattening/SceneTriangles.h>
#include <osgLego/model/CpuBricks.h>

#include <atomic>
#include <string>

#include <osg/Notify>

namespace osgLego
{

namespace
{

osg::ref_ptr<const BrickModel> fail(const std::string& error)
{
    OSG_WARN << "osgLego: " << error << std::endl;
    return nullptr;
}

} // namespace

osg::ref_ptr<const BrickModel> legolizeOnCpu(const osg::Node& node, const LegoSettings& settings,
                                             LegoStatistics* statistics, const std::function<bool(double)>& proceed)
{
    if (const std::string error = settings.check(); !error.empty()) return fail(error);
    const osg::ref_ptr<const SceneTriangles> scene = SceneTriangles::create(node);
    scene->warnOfTexts(node);
    if (scene->getNumTriangles() == 0) return fail("'" + node.getName() + "' has no visible triangles to legolize");
    std::string error;
    const osg::ref_ptr<const LegoSource> source = createFirstSource(*scene, settings, error);
    if (!source) return fail(error);

    std::atomic<bool> isCancelled = false;
    CpuBricksWork work;
    work.isCancelled = [&] { return isCancelled.load(); };
    if (proceed)
        work.progress = [&](const LegoProgress& progress)
        {
            if (!proceed(progress.stage == LegoProgress::Stage::PARTS ? progress.fraction : 1.0)) isCancelled = true;
        };
    if (proceed && !proceed(0.0)) return nullptr;
    osg::ref_ptr<const BrickModel> model = makeBricksOnCpu(*source, work);
    if (!work.error.empty()) return fail(work.error);
    if (!work.warning.empty()) OSG_WARN << "osgLego: " << work.warning << std::endl;
    if (isCancelled) return nullptr;
    if (statistics)
    {
        *statistics = work.statistics;
        if (work.measureLayout) statistics->layout = work.measureLayout();
    }
    return model;
}

} // namespace osgLego
