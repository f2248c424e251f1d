#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "OcclusionFrames.h"
#include "OcclusionView.h"
#include "Spread.h"

#include <array>
#include <filesystem>
#include <map>
#include <memory>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

struct OcclusionOptions : BenchOptions
{
    int numRays = 512;
    int stride = 3;
    int numFrames = 5;
};

constexpr glm::ivec2 SIZE(1280, 720);
constexpr const char* GRID = "grid";
constexpr std::array QUALITIES{GRID, "low", "medium", "high"};

AmbientOcclusionSettings createSettings(const std::string& quality, bool isDistant)
{
    AmbientOcclusionSettings settings;
    std::string error;
    if (quality != GRID) AmbientOcclusionSettings::parse(quality, settings, error);
    settings.distant = isDistant;
    return settings;
}

BrickOcclusion getOcclusion(const std::string& quality)
{
    return quality == GRID ? BrickOcclusion::GRID : BrickOcclusion::SCREEN;
}

JsonValue compareWithRays(const BenchScene& scene, const std::string& quality, bool isDistant,
                          const OcclusionOptions& options)
{
    fmt::print(stderr, "casting rays at {}, {}\n", scene.mesh.name, quality);
    JsonValue row{{"mesh", scene.mesh.name},  {"resolution", scene.settings.grid.resolution},
                  {"azimuth", scene.azimuth}, {"elevation", scene.elevation},
                  {"quality", quality},       {"distant", isDistant}};
    OcclusionView view(scene, getOcclusion(quality), SIZE);
    row.update(view.compare(createSettings(quality, isDistant), options.numRays, options.stride));
    return row;
}

/** The median times of drawing bricks and of each following pass, in milliseconds. */
JsonValue timePasses(BenchScene scene, const std::string& quality, int numFrames)
{
    scene.settings.grid.resolution = 128;
    OcclusionView view(scene, getOcclusion(quality), SIZE);
    const AmbientOcclusionSettings settings = createSettings(quality, true);
    view.draw(settings); // legolizes and creates programs
    std::map<std::string, std::vector<double>> all;
    for (int frame = 0; frame < numFrames; ++frame)
    {
        view.draw(settings);
        const AmbientOcclusionTimes times = view.getTimes();
        all["bricks"].push_back(times.geometry);
        all["resolve"].push_back(times.resolve);
        all["occlusion"].push_back(times.occlusion);
        all["denoise"].push_back(times.denoise);
        all["composite"].push_back(times.composite);
    }
    JsonValue row{{"mesh", scene.mesh.name}, {"resolution", scene.settings.grid.resolution}, {"quality", quality}};
    for (const auto& [pass, times] : all)
        row["milliseconds"][pass] = createSpread(times)["median"];
    return row;
}

/** Frames of a mesh at 128 cells without ambient occlusion and with both kinds, from four views. */
JsonValue compareFrames(const BenchScene& scene, const OcclusionOptions& options)
{
    struct View
    {
        const char* name;
        double elevation;
        double distance;
    };
    JsonValue rows;
    for (const View& view : {View{"above", 25.0, 3.5}, {"below", -35.0, 3.5}, {"near", 25.0, 1.3}, {"far", 25.0, 14.0}})
    {
        BenchScene seen = scene;
        seen.settings.grid.resolution = 128;
        seen.elevation = view.elevation;
        seen.distance = view.distance;
        JsonValue row = compareOcclusionFrames(seen, static_cast<unsigned int>(options.numFrames), SIZE);
        row["view"] = view.name;
        rows.append(row);
    }
    return rows;
}

/** Ambient occlusion was tuned on the first view. */
std::vector<BenchScene> createScenes(const OcclusionOptions& options)
{
    std::vector<std::pair<MeshSource, unsigned int>> meshes{{MeshSource(), 32}, {MeshSource{"stair", "stair"}, 10}};
    if (const MeshSource mesh = options.getMesh(); mesh.isFile()) meshes.insert(meshes.begin(), {mesh, 64});
    std::vector<BenchScene> scenes;
    for (const auto& [azimuth, elevation] : {std::pair{30.0, 25.0}, {150.0, 40.0}, {260.0, 10.0}})
        for (const auto& [mesh, resolution] : meshes)
        {
            scenes.emplace_back(mesh, resolution);
            scenes.back().azimuth = azimuth;
            scenes.back().elevation = elevation;
        }
    return scenes;
}

void runOcclusion(const OcclusionOptions& options)
{
    const std::vector<BenchScene> scenes = createScenes(options);
    JsonValue document = createDocument("occlusion", *createBenchContext());
    document["rays"] = options.numRays;
    document["frames"] = options.numFrames;
    for (const BenchScene& scene : scenes)
        for (const char* quality : QUALITIES)
            for (const bool isDistant : {false, true})
                document["errors"].append(compareWithRays(scene, quality, isDistant, options));
    for (const char* quality : QUALITIES)
        if (options.numFrames > 0) document["times"].append(timePasses(scenes.front(), quality, options.numFrames));
    if (options.numFrames > 0) document["frameRows"] = compareFrames(scenes.front(), options);
    options.write(document);
}

} // namespace

void addOcclusionCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add(
        "occlusion", "Ambient occlusion: its error against rays cast at the bricks, and the time of each pass");
    const auto options = std::make_shared<OcclusionOptions>();
    options->addTo(command, "fixed");
    command.addNumber("--rays", options->numRays, "Rays per pixel (512)", 1, 65536);
    command.addNumber("--stride", options->stride, "Compare every nth pixel along both axes (3)", 1, 100);
    command.addNumber("--frames", options->numFrames, "Timed frames; 0: none (5)", 0, 1000);
    command.setRun([options] { runOcclusion(*options); });
}

} // namespace osgLego
