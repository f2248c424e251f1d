#include "UnchangedFrames.h"

#include "AllocationCount.h"
#include "BenchEnvironment.h"
#include "BenchView.h"
#include "FrameViewer.h"
#include "GlWatch.h"

#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <stdexcept>

#include <osg/Geode>
#include <osg/ShapeDrawable>

namespace osgLego
{

namespace
{

constexpr std::size_t NUM_FRAMES = 20;
constexpr std::size_t NUM_FRAMES_BEFORE = 20; // longer than idle passes are kept

osg::ref_ptr<osg::Node> createBox()
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(new osg::ShapeDrawable(new osg::Box));
    return geode;
}

/** @param lego of the node; null: it has no bricks.
 * @param changes whether the bricks are made anew in each frame. */
void count(osg::Node& node, LegoNode* lego, const BenchScene& scene, const glm::ivec2& size, bool changes,
           UnchangedFrames& result)
{
    FrameViewer viewer(size);
    viewer.show(node, scene);
    for (std::size_t frame = 0; frame < NUM_FRAMES_BEFORE; ++frame)
        viewer.drawFrame();
    const auto countPasses = [&]() -> std::size_t
    { return lego ? lego->getStatistics(viewer.getContextID()).numLegolizations : 0; };
    if (lego && !lego->isLegolized(viewer.getContextID()))
        throw std::runtime_error(lego->getFailure(viewer.getContextID()));
    const std::size_t passes = countPasses();
    const std::size_t waits = GlWatch::countWaits();
    const AllocationCount before = AllocationCount::now();
    for (std::size_t frame = 0; frame < NUM_FRAMES; ++frame)
    {
        if (changes) lego->dirty();
        viewer.drawFrame();
    }
    const AllocationCount after = AllocationCount::now();
    result.numFrames = NUM_FRAMES;
    result.numWaits = GlWatch::countWaits() - waits;
    result.numPasses = countPasses() - passes;
    result.numAllocations = after.ofAllThreads - before.ofAllThreads;
    result.numOwnAllocations = after.ofThisThread - before.ofThisThread;
}

osg::ref_ptr<LegoNode> createLego(const BenchScene& scene, Look look)
{
    LegoSettings settings = scene.settings;
    settings.look = look;
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    lego->addChild(createBenchMesh(scene.mesh));
    return lego;
}

} // namespace

std::vector<UnchangedFrames> countInUnchangedFrames(const BenchScene& scene, const glm::ivec2& size)
{
    std::vector<UnchangedFrames> results;
    const auto add =
        [&](const char* name, const char* look, bool hasGoal, osg::Node& node, LegoNode* lego, bool changes = false)
    {
        results.push_back({name, look, hasGoal, 0, 0, 0, 0, 0});
        count(node, lego, scene, size, changes, results.back());
    };
    add("a box of OSG's", "none", false, *createBox(), nullptr);
    const bool hasSplats = BenchEnvironment::find(FrameViewer(size).getContext()).isSoftware();
    for (const auto& [look, lookName] : {std::pair{Look::PLAIN, "plain"}, {Look::FULL, "full"}})
    {
        if (hasSplats)
        {
            const osg::ref_ptr<LegoNode> splats = createLego(scene, look);
            add("splats", lookName, true, *splats, splats);
        }
        const osg::ref_ptr<LegoNode> triangles = createLego(scene, look);
        drawByTriangles(*triangles);
        add("triangles", lookName, true, *triangles, triangles);
    }
    const osg::ref_ptr<LegoNode> lego = createLego(scene, Look::FULL);
    const osg::ref_ptr<AmbientOcclusionScene> occlusion = new AmbientOcclusionScene;
    occlusion->addChild(lego);
    add("with ambient occlusion", "full", false, *occlusion, lego);
    BenchScene byPasses = scene;
    byPasses.settings.device = Device::GPU;
    const osg::ref_ptr<LegoNode> anew = createLego(byPasses, Look::FULL);
    add("made anew by the passes", "full", false, *anew, anew, true);
    return results;
}

} // namespace osgLego
