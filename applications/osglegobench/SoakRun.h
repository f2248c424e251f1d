#pragma once

#include "BenchScene.h"

#include <osgLego/LegoNode.h>

#include <array>
#include <cstddef>
#include <memory>
#include <random>

#include <osg/Group>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Nodes in bricks in two viewers, which change at random as in a program that runs for hours. The same sequence in
 * every run. One thread. */
class SoakRun
{
public:
    SoakRun();

    /** Change something at random: a source, settings, a light probe, the occlusion, a node, or a viewer, which is
     * closed and opened again with another size. Then draw frames. */
    void change();
    /** Return to the state of the beginning, and draw frames: memory is comparable between such states alone. */
    void rest();

private:
    static constexpr std::size_t NUM_NODES = 3;

    std::size_t choose(std::size_t count);
    LegoNode& chooseNode() { return *_nodes[choose(NUM_NODES)]; }
    void setSource(LegoNode& node, std::size_t source);
    void setSettings(LegoNode& node, std::size_t settings);
    void setProbe(LegoNode& node);
    void setOcclusion(LegoNode& node, std::size_t occlusion);
    void replaceNode(std::size_t place);
    void reopen(std::size_t viewer, const glm::ivec2& size);
    void draw();

    std::mt19937 _random{1};
    BenchScene _scene;
    osg::ref_ptr<osg::Group> _root;
    std::array<osg::ref_ptr<LegoNode>, NUM_NODES> _nodes;
    std::array<std::unique_ptr<FrameViewer>, 2> _viewers;
};

} // namespace osgLego
