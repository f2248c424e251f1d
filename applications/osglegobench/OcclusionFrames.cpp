#include "OcclusionFrames.h"

#include "Spread.h"

#include <osgLego/AmbientOcclusionScene.h>

#include <array>
#include <vector>

#include <osg/Switch>

namespace osgLego
{

namespace
{

constexpr std::array KINDS{"open", "grid", "screen"};

/** A switch between nodes for the three kinds. */
osg::ref_ptr<osg::Switch> createKinds(const BenchScene& scene, std::vector<osg::ref_ptr<LegoNode>>& nodes)
{
    osg::ref_ptr<osg::Switch> kinds = new osg::Switch;
    for (std::size_t kind = 0; kind < KINDS.size(); ++kind)
    {
        const osg::ref_ptr<LegoNode> lego = scene.createLego(kind == 0   ? BrickOcclusion::OFF
                                                             : kind == 1 ? BrickOcclusion::GRID
                                                                         : BrickOcclusion::SCREEN);
        nodes.push_back(lego);
        if (kind < 2)
        {
            kinds->addChild(lego);
            continue;
        }
        const osg::ref_ptr<AmbientOcclusionScene> screen = new AmbientOcclusionScene;
        screen->addChild(lego);
        kinds->addChild(screen);
    }
    return kinds;
}

} // namespace

JsonValue compareOcclusionFrames(const BenchScene& scene, unsigned int numFrames, const glm::ivec2& size)
{
    constexpr unsigned int NUM_ROUNDS_BEFORE = 3;
    FrameViewer viewer(size);
    std::vector<osg::ref_ptr<LegoNode>> nodes;
    const osg::ref_ptr<osg::Switch> kinds = createKinds(scene, nodes);
    viewer.show(*kinds, scene);
    std::array<std::vector<double>, KINDS.size()> times;
    for (unsigned int round = 0; round < NUM_ROUNDS_BEFORE + numFrames; ++round)
        for (unsigned int kind = 0; kind < KINDS.size(); ++kind)
        {
            kinds->setSingleChildOn(kind);
            const double time = viewer.timeFrame();
            if (round == 0) checkPicture(*viewer.read());
            if (round >= NUM_ROUNDS_BEFORE) times[kind].push_back(time);
        }
    JsonValue row{{"mesh", scene.mesh.name}, {"resolution", scene.settings.grid.resolution}};
    for (std::size_t kind = 0; kind < KINDS.size(); ++kind)
    {
        checkBricks(*nodes[kind], viewer);
        row[KINDS[kind]] = createSpread(times[kind]);
    }
    for (const char* kind : {"grid", "screen"})
        row["ratios"][kind] = row[kind]["median"].toNumber() / row["open"]["median"].toNumber();
    return row;
}

} // namespace osgLego
