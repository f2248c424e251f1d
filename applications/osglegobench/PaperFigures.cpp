#include "BenchView.h"
#include "Figures.h"
#include "LegoNodeContender.h"

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

/** The median milliseconds of a frame. */
double measureFrames(BenchView& view, const BenchRuns& runs, bool legolizesAnew)
{
    std::vector<double> times;
    for (unsigned int run = 0; run < runs.numWarmUps + runs.numRuns; ++run)
    {
        if (legolizesAnew) view.getLegoNode().dirty();
        const osg::Timer_t start = osg::Timer::instance()->tick();
        view.drawFrame(AmbientOcclusionSettings());
        if (run >= runs.numWarmUps)
            times.push_back(osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick()));
    }
    return Spread::create(times).median;
}

BenchScene createScene(const MeshSource& source, unsigned int resolution)
{
    BenchScene scene;
    scene.name = source.name;
    scene.mesh = source.path;
    scene.settings.resolution = resolution;
    scene.settings.upAxis = source.upAxis;
    return scene;
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
        for (const unsigned int resolution : resolutions)
        {
            fmt::print(stderr, "drawing {} at {}\n", source.name, resolution);
            BenchView view(createScene(source, resolution), {WIDTH, HEIGHT}, PictureUse::DISCARD);
            const std::string name = nameOf(source, numTriangles);
            plot.getCurve(name).points.emplace_back(resolution, 1000.0 / measureFrames(view, runs, false));
            Plot::Curve& anew = plot.getCurve(name + ", legolized in each frame");
            anew.isVariant = true;
            anew.points.emplace_back(resolution, 1000.0 / measureFrames(view, runs, true));
        }
    }
    return plot;
}

} // namespace osgLego
