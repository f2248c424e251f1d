#include "BenchView.h"
#include "Figures.h"
#include "LegoNodeContender.h"

#include <memory>

#include <fmt/format.h>
#include <osg/Timer>

namespace osgLego
{

namespace
{

constexpr int WIDTH = 1280;
constexpr int HEIGHT = 720;

std::string nameOf(const MeshSource& source, std::size_t numTriangles)
{
    return fmt::format("{}, {} triangles", source.name, numTriangles);
}

double measureFrame(BenchView& view)
{
    const osg::Timer_t start = osg::Timer::instance()->tick();
    view.drawFrame(AmbientOcclusionSettings());
    return osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
}

/** The milliseconds of frames of a mesh at one resolution. */
struct FrameTimes
{
    std::vector<double> unchanged;
    std::vector<double> legolizedAnew;
};

/** Those at all resolutions, in turns, so that whatever else the machine does meets all alike. */
std::vector<FrameTimes> measureFrames(const std::vector<std::unique_ptr<BenchView>>& views, const BenchRuns& runs)
{
    std::vector<FrameTimes> times(views.size());
    for (unsigned int run = 0; run < runs.numWarmUps + runs.numRuns; ++run)
        for (std::size_t index = 0; index < views.size(); ++index)
        {
            BenchView& view = *views[index];
            view.getLegoNode().dirty();
            const double legolizedAnew = measureFrame(view);
            const double unchanged = measureFrame(view);
            if (run < runs.numWarmUps) continue;
            times[index].legolizedAnew.push_back(legolizedAnew);
            times[index].unchanged.push_back(unchanged);
        }
    return times;
}

double toRate(const std::vector<double>& milliseconds)
{
    return 1000.0 / Spread::create(milliseconds).median;
}

} // namespace

Plot measureFboSizes(const std::vector<MeshSource>& meshes, unsigned int resolution,
                     const std::vector<unsigned int>& sizes, const BenchRuns& runs, osg::GraphicsContext& context)
{
    ContenderList contenders;
    for (const unsigned int size : sizes)
        contenders.push_back(std::make_unique<LegoNodeContender>(
            std::to_string(size), fmt::format("method=points,target=projected,edge=1,fbo={}", size)));
    Plot plot{fmt::format("The paper's method at {} over the frame buffer object (its Figure 6a)", resolution),
              "pixels along a side",
              "milliseconds, subdivision to bricks",
              {}};
    for (const MeshSource& source : meshes)
    {
        fmt::print(stderr, "measuring {} with frame buffer objects\n", source.name);
        const osg::ref_ptr<osg::Node> node = readMesh(source);
        const MeshResult result =
            measureContenders(createBenchMesh(source, *node, resolution), contenders, runs, context, false);
        Plot::Curve& curve = plot.getCurve(nameOf(source, result.numTriangles));
        for (std::size_t index = 0; index < sizes.size(); ++index)
            if (result.contenders[index].failure.empty())
                curve.points.emplace_back(sizes[index], result.contenders[index].time.median);
    }
    return plot;
}

Plot measureFrameRates(const std::vector<MeshSource>& meshes, const std::vector<unsigned int>& resolutions,
                       const BenchRuns& runs)
{
    Plot plot{fmt::format("Frames of {} x {} with ambient occlusion over the resolution (the paper's Figure 6b)", WIDTH,
                          HEIGHT),
              "cells along the longest side",
              "frames a second",
              {}};
    for (const MeshSource& source : meshes)
    {
        const std::size_t numTriangles = SceneTriangles::create(*readMesh(source))->getNumTriangles();
        fmt::print(stderr, "drawing {}\n", source.name);
        std::vector<std::unique_ptr<BenchView>> views;
        views.reserve(resolutions.size());
        for (const unsigned int resolution : resolutions)
            views.push_back(std::make_unique<BenchView>(createBenchScene(source, resolution), glm::ivec2(WIDTH, HEIGHT),
                                                        PictureUse::DISCARD));
        const std::vector<FrameTimes> times = measureFrames(views, runs);
        const std::string name = nameOf(source, numTriangles);
        for (std::size_t index = 0; index < resolutions.size(); ++index)
        {
            plot.getCurve(name).points.emplace_back(resolutions[index], toRate(times[index].unchanged));
            Plot::Curve& anew = plot.getCurve(name + ", legolized in each frame");
            anew.isVariant = true;
            anew.points.emplace_back(resolutions[index], toRate(times[index].legolizedAnew));
        }
    }
    return plot;
}

} // namespace osgLego
