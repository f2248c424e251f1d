#include "AllocationCount.h"
#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "BenchScene.h"
#include "Commands.h"
#include "NodesComparison.h"
#include "ResidentMemory.h"
#include "ShadowComparison.h"
#include "Spread.h"

#include <osgLego/AmbientOcclusionScene.h>

#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <osg/Geode>
#include <osg/ShapeDrawable>

namespace osgLego
{

namespace
{

struct DrawOptions : BenchOptions
{
    std::string look = "full"; // "none": an osg::Box instead of bricks
    std::string device = "auto";
    std::string drawing = "auto";
    bool hasParts = false;
    bool hasOcclusion = false;
    unsigned int numFrames = 20;
    unsigned int numNodes = 0; // 0: one scene, not compared with others
    std::string shadows;       // a technique; empty: no shadows

    glm::ivec2 getSize() const { return isQuick ? glm::ivec2(160, 90) : glm::ivec2(1280, 720); }
    unsigned int getResolution(unsigned int usual) const { return getResolutions({16}, {usual}).front(); }
    BenchScene createScene(const MeshSource& mesh, unsigned int resolution) const
    {
        BenchScene scene(mesh, resolution);
        std::string error;
        if (!LegoSettings::parse(fmt::format("device={},drawing={},look={}{}", device, drawing,
                                             look == "none" ? "full" : look, hasParts ? ",parts=bricks" : ""),
                                 scene.settings, error))
            throw std::runtime_error(error);
        return scene;
    }
};

/** Draw the same frame repeatedly.
 * @param lego null if there are no bricks.
 * @param isDirtied whether the source is legolized again in each frame. */
JsonValue drawFrames(FrameViewer& viewer, LegoNode* lego, unsigned int numFrames, bool isDirtied)
{
    const auto countLegolizations = [&]
    { return lego ? lego->getStatistics(viewer.getContextID()).numLegolizations : 0; };
    std::vector<double> times;
    times.reserve(numFrames);
    const unsigned int legolizations = countLegolizations();
    const std::size_t allocations = AllocationCount::getNumAllocations();
    for (unsigned int frame = 0; frame < numFrames; ++frame)
    {
        if (isDirtied) lego->dirty();
        times.push_back(viewer.timeFrame(isDirtied ? "dirtied" : "unchanged"));
    }
    const std::size_t numAllocations = AllocationCount::getNumAllocations() - allocations;
    return {{"legolizations", countLegolizations() - legolizations},
            {"allocations", numAllocations},
            {"milliseconds", createSpread(times)}};
}

/** Draw the whole model and, in turns with it, the model as its building progresses from no part to all parts. */
JsonValue drawProgress(FrameViewer& viewer, LegoNode& lego, unsigned int numFrames)
{
    constexpr unsigned int NUM_TENTHS = 10;
    std::vector<double> whole;
    std::vector<double> partial;
    std::vector<std::vector<double>> tenths(NUM_TENTHS);
    lego.setWaiting(true); // for the order of building
    for (const double progress : {0.5, 1.0})
    {
        lego.setBuildProgress(progress);
        viewer.drawFrame();
    }
    for (unsigned int frame = 0; frame < numFrames; ++frame)
    {
        whole.push_back(viewer.timeFrame("whole"));
        lego.setBuildProgress((frame + 0.5) / numFrames);
        partial.push_back(viewer.timeFrame("partial"));
        tenths[NUM_TENTHS * frame / numFrames].push_back(partial.back());
        lego.setBuildProgress(1.0);
    }
    JsonValue row{{"whole", createSpread(whole)}, {"partial", createSpread(partial)}};
    for (const std::vector<double>& times : tenths)
        if (!times.empty()) row["medianByTenth"].append(createSpread(times)["median"]);
    return row;
}

osg::ref_ptr<osg::Node> createBox()
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(new osg::ShapeDrawable(new osg::Box));
    return geode;
}

/** Measure the peak memory after the first frame, then times and counts of frames. */
JsonValue measure(const DrawOptions& options, FrameViewer& viewer)
{
    constexpr double MEBIBYTE = 1024.0 * 1024.0;
    constexpr unsigned int NUM_FRAMES_BEFORE = 20; // more than idle passes are kept
    const BenchScene scene = options.createScene(options.getMesh(), options.getResolution(64));
    const osg::ref_ptr<LegoNode> lego = options.look == "none" ? nullptr
                                        : options.hasOcclusion ? scene.createLego(BrickOcclusion::SCREEN)
                                                               : scene.createLego();
    const osg::ref_ptr<osg::Node> drawn = lego ? lego.get() : createBox();
    const osg::ref_ptr<osg::Group> root = options.hasOcclusion ? new AmbientOcclusionScene : new osg::Group;
    root->addChild(drawn);
    viewer.show(*root, scene);
    viewer.timeFrame("first");
    JsonValue row{{"mesh", scene.mesh.name},
                  {"resolution", scene.settings.grid.resolution},
                  {"device", options.device},
                  {"look", options.look},
                  {"parts", options.hasParts},
                  {"drawnBy", lego && options.drawing != "triangles" ? "splats" : "triangles"},
                  {"occlusion", options.hasOcclusion},
                  {"frames", options.numFrames},
                  {"mebibytes",
                   {{"resident", readPeakMemory()},
                    {"largestBlock", static_cast<double>(AllocationCount::getLargestBlock()) / MEBIBYTE}}}};
    if (lego)
    {
        checkBricks(*lego, viewer);
        checkPicture(*viewer.read());
        const LegoStatistics statistics = lego->getStatistics(viewer.getContextID());
        row["triangles"] = statistics.numTriangles;
        row["drawnBricks"] = statistics.numDrawnBricks;
    }
    if (options.numFrames == 0) return row;
    for (unsigned int frame = 1; frame < NUM_FRAMES_BEFORE; ++frame)
        viewer.drawFrame();
    row["unchanged"] = drawFrames(viewer, lego, options.numFrames, false);
    if (lego) row["progress"] = drawProgress(viewer, *lego, options.numFrames);
    // Laying parts takes seconds.
    if (lego && !options.hasParts) row["dirtied"] = drawFrames(viewer, lego, options.numFrames, true);
    return row;
}

/** Compare many nodes with one. */
void runNodes(const DrawOptions& options)
{
    if (options.look == "none") throw std::runtime_error("--nodes draws bricks; expected --look plain or full");
    if (options.numFrames == 0) throw std::runtime_error("--nodes times frames; expected --frames of at least 1");
    const MeshSource mesh = options.getMesh(); // checks the options
    const BenchScene scene =
        options.createScene(options.meshes.empty() ? MeshSource() : mesh, options.getResolution(12));
    const JsonValue figures =
        compareNodes(scene, {options.numNodes, options.numFrames, options.hasOcclusion, options.getSize()});
    JsonValue document = createDocument("nodes", *createBenchContext());
    document["width"] = options.getSize().x;
    document["height"] = options.getSize().y;
    document["mesh"] = scene.mesh.name;
    document["settings"] = scene.settings.toString();
    document["occlusion"] = options.hasOcclusion;
    document.update(figures);
    if (!options.jsonFile.empty()) return options.write(document);
    printNodes(document);
}

/** Compare frames with and without shadows. */
void runShadows(const DrawOptions& options)
{
    if (options.look == "none") throw std::runtime_error("--shadows draws bricks; expected --look plain or full");
    if (options.numFrames == 0) throw std::runtime_error("--shadows times frames; expected --frames of at least 1");
    const MeshSource mesh = options.getMesh(); // reports bad options before there is a context
    JsonValue document = createDocument("shadows", *createBenchContext());
    document["width"] = options.getSize().x;
    document["height"] = options.getSize().y;
    document["mesh"] = mesh.name;
    document["technique"] = options.shadows;
    for (const unsigned int resolution : options.getResolutions({16}, {64, 128, 256}))
        document["rows"].append(compareShadows(options.createScene(mesh, resolution),
                                               {options.shadows, options.numFrames, options.getSize()}));
    if (!options.jsonFile.empty()) return options.write(document);
    printShadows(document);
}

void runDraw(const DrawOptions& options)
{
    if (options.numNodes > 0) return runNodes(options);
    if (!options.shadows.empty()) return runShadows(options);
    options.getMesh(); // reports bad options before there is a context
    FrameViewer viewer(options.getSize());
    JsonValue document = createDocument("draw", viewer.getContext());
    document["width"] = options.getSize().x;
    document["height"] = options.getSize().y;
    document["rows"].append(measure(options, viewer));
    options.write(document);
}

} // namespace

void addDrawCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add(
        "draw",
        "Frames of one scene: peak memory after the first; then times, legolizations and allocations of frames "
        "in which nothing has changed, of frames of the model partly built, and of frames in which the bricks are "
        "made again");
    const auto options = std::make_shared<DrawOptions>();
    options->addTo(command, "64");
    command.addChoice("--look", options->look, "plain, full, or none: a box without bricks (full)",
                      {"plain", "full", "none"});
    command.addChoice("--device", options->device, "Device that finds the bricks: auto, gpu, cpu (auto)",
                      {"auto", "gpu", "cpu"});
    command.addChoice("--drawing", options->drawing, "auto, triangles, splats (auto)", {"auto", "triangles", "splats"});
    command.addFlag("--parts", options->hasParts, "Join cells to real bricks");
    command.addFlag("--occlusion", options->hasOcclusion,
                    "Draw with ambient occlusion in the picture, instead of that of the grid in the full look");
    command.addNumber("--frames", options->numFrames, "Frames of each kind; 0: only the first (20)", 0u, 10000u);
    command.addNumber("--nodes", options->numNodes,
                      "Instead, compare so many nodes of a mesh (car, at 12) with one node, and with one node that has "
                      "the same bricks; prints tables unless JSON goes to a file",
                      0u, 10000u);
    command.addChoice(
        "--shadows", options->shadows,
        "Instead, compare frames at 64, 128 and 256 cells, or --resolution, without and with the shadows of "
        "a technique of osgShadow; prints a table unless JSON goes to a file",
        getShadowTechniques());
    command.setRun([options] { runDraw(*options); });
}

} // namespace osgLego
