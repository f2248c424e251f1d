#include "Commands.h"

#include "OcclusionBench.h"
#include "SharedOptions.h"

#include <cstdio>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

struct OcclusionOptions
{
    std::string models = "build/models";
    int numRays = 512;
    int stride = 3;
    int numFrames = 5;
};

constexpr std::pair<AmbientOcclusionQuality, const char*> QUALITIES[]{{AmbientOcclusionQuality::LOW, "low"},
                                                                      {AmbientOcclusionQuality::MEDIUM, "medium"},
                                                                      {AmbientOcclusionQuality::HIGH, "high"}};

void printErrors(const std::vector<BenchScene>& scenes, int numRays, int stride)
{
    fmt::print(
        "Visibility in screen space against {} rays a pixel, radius {} bricks; the constants were tuned on the first "
        "view\n\n",
        numRays, AmbientOcclusionSettings::RADIUS_IN_BRICKS);
    fmt::print(
        "| scene    | view    | quality | pixels | RMSE   | mean error | PSNR dB | one grey | bent mean | bent 95 % "
        "| irradiance |\n"
        "|----------|---------|---------|--------|--------|------------|---------|----------|-----------|----------"
        "-|------------|\n");
    for (const BenchScene& scene : scenes)
        for (const auto& [quality, name] : QUALITIES)
        {
            const OcclusionError error = measureOcclusion(scene, quality, numRays, stride);
            fmt::print("| {:8} | {:3.0f},{:<3.0f} | {:7} | {:6} | {:.4f} | {:+10.4f} | {:7.1f} | {:8.4f} | {:8.1f}° | "
                       "{:8.1f}° | {:9.1f}% |\n",
                       scene.name, scene.azimuth, scene.elevation, name, error.numPixels, error.rootMeanSquare,
                       error.mean, -20.0 * std::log10(error.rootMeanSquare), error.constant, error.bentMean,
                       error.bentMost, 100.0 * error.irradiance);
            std::fflush(stdout);
        }
}

void printTimes(BenchScene scene, int numFrames)
{
    constexpr int WIDTH = 1280;
    constexpr int HEIGHT = 720;
    scene.settings.resolution = 128;
    fmt::print("\nMilliseconds a frame at {} x {}, {} at 128, medians of {}\n\n", WIDTH, HEIGHT, scene.name, numFrames);
    fmt::print("| quality | bricks  | resolve | occlusion | denoise | composite | passes together, over bricks |\n"
               "|---------|---------|---------|-----------|---------|-----------|------------------------------|\n");
    for (const auto& [quality, name] : QUALITIES)
    {
        const AmbientOcclusionTimes times = measureOcclusionTimes(scene, quality, WIDTH, HEIGHT, numFrames);
        const double passes = times.resolve + times.occlusion + times.denoise + times.composite;
        fmt::print("| {:7} | {:7.1f} | {:7.1f} | {:9.1f} | {:7.1f} | {:9.1f} | {:13.1f} ms, {:8.3f} |\n", name,
                   times.geometry, times.resolve, times.occlusion, times.denoise, times.composite, passes,
                   passes / times.geometry);
        std::fflush(stdout);
    }
}

} // namespace

void addOcclusionCommand(CLI::App& app)
{
    CLI::App* command = app.add_subcommand(
        "occlusion", "Ambient occlusion: its error against rays cast at the bricks, and the time of each pass");
    const auto options = std::make_shared<OcclusionOptions>();
    addModelsOption(*command, options->models, "bunny.ply");
    command->add_option("--rays", options->numRays, "Rays a pixel (512)")->check(CLI::Range(1, 65536));
    command->add_option("--stride", options->stride, "Compare every so many pixels along both axes (3)")
        ->check(CLI::Range(1, 100));
    command->add_option("--frames", options->numFrames, "Frames that are timed; 0: none (5)")
        ->check(CLI::Range(0, 1000));
    command->callback(
        [options]
        {
            const std::vector<BenchScene> scenes = createOcclusionScenes(options->models);
            printErrors(scenes, options->numRays, options->stride);
            if (options->numFrames > 0) printTimes(scenes.front(), options->numFrames);
        });
}

} // namespace osgLego
