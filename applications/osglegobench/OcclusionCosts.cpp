#include "OcclusionCosts.h"

#include "SeparateProcess.h"
#include "Spread.h"

#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/data/BrickNeighbors.h>
#include <osgLego/data/BrickPoints.h>
#include <osgLego/data/DistantOcclusion.h>

#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include <osg/Timer>

namespace osgLego
{

namespace
{

constexpr std::array OCCLUSIONS{std::pair{"open", BrickOcclusion::OFF}, std::pair{"grid", BrickOcclusion::GRID},
                                std::pair{"screen", BrickOcclusion::SCREEN}};

JsonValue timeFirstFrame(const BenchScene& scene, BrickOcclusion occlusion, const glm::ivec2& size)
{
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    const osg::ref_ptr<LegoNode> lego = scene.createLego(occlusion);
    const osg::ref_ptr<osg::Group> root =
        occlusion == BrickOcclusion::SCREEN ? new AmbientOcclusionScene : new osg::Group;
    root->addChild(lego);
    FrameViewer viewer(size);
    viewer.show(*root, scene);
    const double first = viewer.timeFrame("first");
    checkBricks(*lego, viewer);
    checkPicture(*viewer.read());
    return first;
}

double sumOf(const LegoStatistics& times)
{
    return times.flattening + times.subdivision + times.voxelization + times.extraction;
}

/** @return the median milliseconds of a legolization and of its extraction. */
std::pair<double, double> timeLegolization(BenchScene scene, Device device, BrickOcclusion occlusion,
                                           unsigned int numRuns)
{
    scene.settings.voxelization.device = device;
    const osg::ref_ptr<LegoNode> lego = scene.createLego(occlusion);
    BrickAppearance appearance = lego->getAppearance();
    appearance.distantOcclusion = false;
    lego->setAppearance(appearance);
    lego->setTiming(true);
    FrameViewer viewer({64, 64});
    viewer.show(*lego, scene);
    viewer.drawFrame(); // from the second one on, neighbours are found with the bricks
    std::vector<double> all;
    std::vector<double> extractions;
    for (unsigned int run = 0; run < numRuns; ++run)
    {
        lego->dirty();
        viewer.drawFrame();
        const LegoStatistics times = lego->getStatistics(viewer.getContextID());
        all.push_back(sumOf(times));
        extractions.push_back(times.extraction);
    }
    checkBricks(*lego, viewer);
    checkPicture(*viewer.read());
    return {createSpread(all)["median"].toNumber(), createSpread(extractions)["median"].toNumber()};
}

template <typename Function>
double timeMedian(unsigned int numRuns, const Function& function)
{
    std::vector<double> times;
    for (unsigned int run = 0; run < numRuns; ++run)
    {
        const osg::Timer_t start = osg::Timer::instance()->tick();
        function();
        times.push_back(osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick()));
    }
    return createSpread(times)["median"].toNumber();
}

} // namespace

JsonValue compareFirstFrames(const BenchScene& scene, const glm::ivec2& size, unsigned int numRuns)
{
    std::array<std::vector<double>, OCCLUSIONS.size()> times;
    for (unsigned int run = 0; run < numRuns; ++run)
        for (std::size_t kind = 0; kind < OCCLUSIONS.size(); ++kind)
            times[kind].push_back(
                measureInSeparateProcess([&] { return timeFirstFrame(scene, OCCLUSIONS[kind].second, size); })
                    .toNumber());
    JsonValue row{{"mesh", scene.mesh.name}, {"resolution", scene.settings.grid.resolution}};
    for (std::size_t kind = 0; kind < OCCLUSIONS.size(); ++kind)
        row[OCCLUSIONS[kind].first] = createSpread(times[kind]);
    for (const char* kind : {"grid", "screen"})
        row["added"][kind] = (row[kind]["median"].toNumber() - row["open"]["median"].toNumber()) / 1000.0;
    return row;
}

JsonValue timeNeighbors(const BenchScene& scene, unsigned int numRuns)
{
    const osg::ref_ptr<const BrickModel> bricks = scene.createLego()->getBricks();
    const BrickPoints points = createBrickPoints(*bricks);
    const double cpu = timeMedian(numRuns, [&] { createBrickNeighbors(points.points); });
    const double distant =
        timeMedian(numRuns, [&] { DistantOcclusion::create(bricks->getGrid(), points.points, NearOcclusion::GRID); });
    const auto [cpuAll, cpuExtraction] = timeLegolization(scene, Device::CPU, BrickOcclusion::OFF, numRuns);
    const auto [gpuAll, gpuExtraction] = timeLegolization(scene, Device::GPU, BrickOcclusion::OFF, numRuns);
    const auto [gridAll, gridExtraction] = timeLegolization(scene, Device::GPU, BrickOcclusion::GRID, numRuns);
    const double gpu = gridExtraction - gpuExtraction;
    return {{"mesh", scene.mesh.name},       {"resolution", scene.settings.grid.resolution},
            {"cpuMilliseconds", cpu},        {"cpuRatio", cpu / cpuAll},
            {"gpuMilliseconds", gpu},        {"gpuRatio", gpu / gpuAll},
            {"distantMilliseconds", distant}};
}

} // namespace osgLego
