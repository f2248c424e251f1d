#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "OcclusionCosts.h"
#include "OcclusionFrames.h"
#include "OcclusionView.h"
#include "Spread.h"

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <osgDB/WriteFile>

namespace osgLego
{

namespace
{

struct OcclusionOptions : BenchOptions
{
    int numRays = 512;
    int stride = 3;
    int numFrames = 5;
    std::string pictures; // the folder; empty: none

    /** Pixels of a frame. */
    glm::ivec2 getSize() const { return isQuick ? glm::ivec2(320, 180) : glm::ivec2(1280, 720); }
    unsigned int getFrameResolution() const { return isQuick ? 32 : 128; }
    unsigned int getNumRuns() const { return isQuick ? 1 : 5; }
};

constexpr unsigned int LARGE_RESOLUTION = 192; // voxels of distant occlusion are larger than cells
constexpr unsigned int FIRST_FRAME_RESOLUTION = 48;
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
    const bool isPlate = scene.settings.grid.proportions == Proportions::PLATE;
    JsonValue row{{"mesh", scene.mesh.name},
                  {"resolution", scene.settings.grid.resolution},
                  {"proportions", isPlate ? "plate" : "cube"},
                  {"azimuth", scene.azimuth},
                  {"elevation", scene.elevation},
                  {"quality", quality},
                  {"distant", isDistant}};
    OcclusionView view(scene, getOcclusion(quality), options.getSize());
    row.update(view.compare(createSettings(quality, isDistant), options.numRays, options.stride));
    return row;
}

/** The median times of drawing bricks and of each following pass, in milliseconds. */
JsonValue timePasses(BenchScene scene, const std::string& quality, const OcclusionOptions& options)
{
    scene.settings.grid.resolution = options.getFrameResolution();
    OcclusionView view(scene, getOcclusion(quality), options.getSize());
    const AmbientOcclusionSettings settings = createSettings(quality, true);
    view.draw(settings); // legolizes and creates programs
    std::map<std::string, std::vector<double>> all;
    for (int frame = 0; frame < options.numFrames; ++frame)
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

/** Frames of a mesh without ambient occlusion and with both kinds, from four views. */
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
        seen.settings.grid.resolution = options.getFrameResolution();
        seen.elevation = view.elevation;
        seen.distance = view.distance;
        JsonValue row = compareOcclusionFrames(seen, static_cast<unsigned int>(options.numFrames), options.getSize());
        row["view"] = view.name;
        rows.append(row);
    }
    return rows;
}

/** Write a picture of visibility, seen against white. */
void writePicture(const osg::Image& visibility, const std::string& path)
{
    osg::ref_ptr<osg::Image> bytes = new osg::Image;
    bytes->allocateImage(visibility.s(), visibility.t(), 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int row = 0; row < visibility.t(); ++row)
        for (int column = 0; column < visibility.s(); ++column)
        {
            const osg::Vec4 color =
                visibility.getColor(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            const float grey = color.r() + 1.0f - color.a();
            bytes->setColor(osg::Vec4(grey, grey, grey, 1.0f), static_cast<unsigned int>(column),
                            static_cast<unsigned int>(row));
        }
    if (!osgDB::writeImageFile(*bytes, path)) throw std::runtime_error("can't write '" + path + "'");
}

/** Pictures of visibility: by rays, in the picture (screen), and in the grid. */
void writePictures(const BenchScene& scene, const OcclusionOptions& options)
{
    const glm::ivec2 size(640, 480);
    BenchScene seen = scene;
    seen.distance = 1.6;
    AmbientOcclusionSettings settings;
    settings.output = AmbientOcclusionOutput::OCCLUSION;
    const auto pathOf = [&](const char* kind)
    { return options.pictures + "/" + scene.mesh.name + "-" + kind + ".png"; };
    OcclusionView screen(seen, BrickOcclusion::SCREEN, size);
    writePicture(*screen.draw(settings), pathOf("screen"));
    fmt::print(stderr, "casting rays for the picture of {}\n", scene.mesh.name);
    writePicture(*screen.drawByRays(settings, options.numRays), pathOf("rays"));
    writePicture(*OcclusionView(seen, BrickOcclusion::GRID, size).draw(settings), pathOf("grid"));
}

/** Ambient occlusion was tuned on the first view. */
std::vector<BenchScene> createScenes(const OcclusionOptions& options)
{
    std::vector<BenchScene> models{BenchScene(MeshSource(), 32), BenchScene(MeshSource{"stair", "stair"}, 10)};
    if (const MeshSource mesh = options.getMesh(); mesh.isFile())
    {
        models.insert(models.begin(), BenchScene(mesh, 64));
        BenchScene plates(mesh, 64);
        plates.settings.grid.proportions = Proportions::PLATE;
        models.push_back(plates);
        models.emplace_back(mesh, LARGE_RESOLUTION);
    }
    std::vector<BenchScene> scenes;
    std::vector<std::pair<double, double>> views{{30.0, 25.0}};
    if (!options.isQuick) views.insert(views.end(), {{150.0, 40.0}, {260.0, 10.0}});
    for (const auto& [azimuth, elevation] : views)
        for (const BenchScene& model : models)
        {
            scenes.push_back(model);
            scenes.back().azimuth = azimuth;
            scenes.back().elevation = elevation;
        }
    return scenes;
}

void runOcclusion(const OcclusionOptions& options)
{
    const std::vector<BenchScene> scenes = createScenes(options);
    if (!options.pictures.empty())
    {
        writePictures(scenes.front(), options);
        return;
    }
    JsonValue costs; // of the first frames; before this process has a context
    if (options.numFrames > 0)
        costs.append(compareFirstFrames(BenchScene(MeshSource(), FIRST_FRAME_RESOLUTION), options.getSize(),
                                        options.getNumRuns()));
    JsonValue document = createDocument("occlusion", *createBenchContext());
    document["rays"] = options.numRays;
    document["frames"] = options.numFrames;
    document["width"] = options.getSize().x;
    document["height"] = options.getSize().y;
    for (const BenchScene& scene : scenes)
        for (const char* quality : QUALITIES)
            for (const bool isDistant : {false, true})
                document["errors"].append(compareWithRays(scene, quality, isDistant, options));
    for (const char* quality : QUALITIES)
        if (options.numFrames > 0) document["times"].append(timePasses(scenes.front(), quality, options));
    if (options.numFrames > 0)
    {
        document["frameRows"] = compareFrames(scenes.front(), options);
        document["firstFrames"] = costs;
        document["neighbors"].append(
            timeNeighbors(BenchScene(scenes.front().mesh, options.getFrameResolution()), options.getNumRuns()));
    }
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
    command.addFolder("--pictures", options->pictures,
                      "Only draw the visibility of the first mesh into this folder: by rays, screen and grid");
    command.setRun([options] { runOcclusion(*options); });
}

} // namespace osgLego
