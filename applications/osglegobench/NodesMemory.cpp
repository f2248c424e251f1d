#include "NodesMemory.h"

#include "BenchScene.h"
#include "GlObjectCount.h"
#include "ResidentMemory.h"
#include "SeparateProcess.h"

#include <osgLego/BrickModel.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

namespace osgLego
{

namespace
{

constexpr double READ_GOAL = 100.0;  // KiB per node
constexpr double DRAWN_GOAL = 500.0; // KiB per node
constexpr int NUM_BRICKS = 5;

std::array<std::uint8_t, 3> chooseColor(unsigned int number)
{
    constexpr unsigned int STEP = 37; // coprime to 256
    return {static_cast<std::uint8_t>(STEP * number), static_cast<std::uint8_t>(number / 4),
            static_cast<std::uint8_t>(255 - number % 256)};
}

/** Five cells in a row, as the content of a file. */
std::string writeStored(unsigned int number, osgDB::ReaderWriter& format)
{
    BrickGrid grid;
    grid.dimensions = {NUM_BRICKS, 1, 1};
    std::vector<Brick> bricks(NUM_BRICKS);
    for (int cell = 0; cell < NUM_BRICKS; ++cell)
    {
        bricks[static_cast<std::size_t>(cell)].cell[0] = static_cast<std::uint16_t>(cell);
        bricks[static_cast<std::size_t>(cell)].color = chooseColor(number);
    }
    const osg::ref_ptr<LegoNode> node = new LegoNode;
    node->setStoredBricks(BrickModel::create(grid, bricks));
    std::ostringstream stream;
    if (!format.writeNode(*node, stream).success()) throw std::runtime_error("can't write a node with stored bricks");
    return stream.str();
}

osg::ref_ptr<LegoNode> readStored(const std::string& content, osgDB::ReaderWriter& format)
{
    std::istringstream stream(content);
    osgDB::ReaderWriter::ReadResult result = format.readNode(stream);
    osg::ref_ptr<LegoNode> node = dynamic_cast<LegoNode*>(result.getNode());
    if (!node) throw std::runtime_error("can't read a node with stored bricks");
    return node;
}

/** The same cells as the bricks of a box. */
osg::ref_ptr<LegoNode> createBoxNode(unsigned int number)
{
    const osg::ref_ptr<osg::ShapeDrawable> box =
        new osg::ShapeDrawable(new osg::Box(osg::Vec3(0.5f * NUM_BRICKS, 0.5f, 0.5f), NUM_BRICKS, 1.0f, 1.0f));
    const auto color = chooseColor(number);
    box->setColor(osg::Vec4(color[0] / 255.0f, color[1] / 255.0f, color[2] / 255.0f, 1.0f));
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(box);
    LegoSettings settings;
    settings.grid.resolution = NUM_BRICKS;
    osg::ref_ptr<LegoNode> node = new LegoNode(settings);
    node->addChild(geode);
    return node;
}

osg::ref_ptr<LegoNode> readSample()
{
    osg::ref_ptr<LegoNode> node =
        dynamic_cast<LegoNode*>(osgDB::readRefNodeFile(fmt::format("sample.{}.legolize", NUM_BRICKS)).get());
    if (!node) throw std::runtime_error("OpenSceneGraph has no plugin for .legolize");
    return node;
}

osg::ref_ptr<LegoNode> createNode(SmallSource source, unsigned int number, osgDB::ReaderWriter& format)
{
    switch (source)
    {
    case SmallSource::STORED:
        return readStored(writeStored(number, format), format);
    case SmallSource::MESH:
        return createBoxNode(number);
    case SmallSource::SAMPLE:
        return readSample();
    }
    throw std::logic_error("no such source");
}

std::string getName(SmallSource source)
{
    return source == SmallSource::STORED ? "stored bricks" : source == SmallSource::MESH ? "meshes" : "sample.legolize";
}

std::vector<osg::ref_ptr<LegoNode>> createNodes(SmallSource source, unsigned int count)
{
    osgDB::ReaderWriter* const format = osgDB::Registry::instance()->getReaderWriterForExtension("osgb");
    if (!format) throw std::runtime_error("OpenSceneGraph has no plugin for .osgb");
    std::vector<osg::ref_ptr<LegoNode>> nodes;
    for (unsigned int number = 0; number < count; ++number)
    {
        nodes.push_back(createNode(source, number, *format));
        nodes.back()->setWaiting(true);
    }
    return nodes;
}

/** Nodes in rows side by side. */
osg::ref_ptr<osg::Group> arrange(const std::vector<osg::ref_ptr<LegoNode>>& nodes)
{
    constexpr double STEP_ACROSS = NUM_BRICKS + 1.0;
    constexpr double STEP_ALONG = 3.0;
    const auto numAcross = static_cast<unsigned int>(std::ceil(std::sqrt(static_cast<double>(nodes.size()))));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    for (unsigned int place = 0; place < nodes.size(); ++place)
    {
        const unsigned int column = place % numAcross;
        const unsigned int row = place / numAcross;
        const osg::ref_ptr<osg::MatrixTransform> transform =
            new osg::MatrixTransform(osg::Matrixd::translate(STEP_ACROSS * column, STEP_ALONG * row, 0.0));
        transform->addChild(nodes[place]);
        root->addChild(transform);
    }
    return root;
}

JsonValue measureMemory()
{
    return {{"resident", readResidentMemory()}, {"heap", readHeapMemory()}};
}

JsonValue measureGl()
{
    const GlObjectCount count = GlObjectCount::count();
    return {{"buffers", count.numBuffers},
            {"bufferBytes", count.bufferBytes},
            {"textures", count.numTextures},
            {"textureBytes", count.textureBytes},
            {"programs", count.numPrograms}};
}

/** Check that all nodes are drawn, which have as many bricks as the first one. */
void checkNodes(const std::vector<osg::ref_ptr<LegoNode>>& nodes, const FrameViewer& viewer)
{
    const std::size_t expected = nodes.front()->getStatistics(viewer.getContextID()).numDrawnBricks;
    for (const osg::ref_ptr<LegoNode>& node : nodes)
    {
        checkBricks(*node, viewer);
        const std::size_t numDrawn = node->getStatistics(viewer.getContextID()).numDrawnBricks;
        if (numDrawn != expected || numDrawn < NUM_BRICKS)
            throw std::runtime_error(fmt::format("a node has {} bricks; expected {}", numDrawn, expected));
    }
}

/** Measure nodes in this process. */
JsonValue measureHere(SmallSource source, unsigned int numNodes, const std::string& picture)
{
    constexpr unsigned int NUM_FRAMES = 20; // more than idle passes are kept
    const BenchScene scene(MeshSource(), NUM_BRICKS);
    FrameViewer viewer({1280, 720});
    // One node, so that programs and tables are there, and one frame without it.
    osg::ref_ptr<osg::Group> root = arrange(createNodes(source, 1));
    viewer.show(*root, scene);
    viewer.timeFrame("first");
    JsonValue figures;
    figures["before"] = measureMemory();
    figures["glBefore"] = measureGl();
    const std::vector<osg::ref_ptr<LegoNode>> nodes = createNodes(source, numNodes);
    figures["read"] = measureMemory();
    root = arrange(nodes);
    viewer.show(*root, scene);
    for (unsigned int frame = 0; frame < NUM_FRAMES; ++frame)
        viewer.timeFrame();
    checkNodes(nodes, viewer);
    figures["drawn"] = measureMemory();
    figures["glDrawn"] = measureGl();
    if (!picture.empty() && !osgDB::writeImageFile(*viewer.read(), picture))
        throw std::runtime_error("can't write '" + picture + "'");
    return figures;
}

JsonValue createMemoryGoal(const char* what, double figure, double goal)
{
    return {{"what", what}, {"figure", figure}, {"goal", goal}, {"reached", figure <= goal}};
}

/** The difference of two figures in MiB, in KiB per node. */
JsonValue perNode(const JsonValue& before, const JsonValue& after, unsigned int numNodes)
{
    constexpr double KIBIBYTES = 1024.0; // per MiB
    const auto difference = [&](const char* figure)
    { return KIBIBYTES * (after[figure].toNumber() - before[figure].toNumber()) / numNodes; };
    return {{"resident", difference("resident")}, {"heap", difference("heap")}};
}

/** The GL objects and their KiB per node. */
JsonValue glPerNode(const JsonValue& before, const JsonValue& after, unsigned int numNodes)
{
    const auto difference = [&](const char* figure)
    { return (after[figure].toNumber() - before[figure].toNumber()) / numNodes; };
    return {{"buffers", difference("buffers")},
            {"bufferKibibytes", difference("bufferBytes") / 1024.0},
            {"textures", difference("textures")},
            {"textureKibibytes", difference("textureBytes") / 1024.0}};
}

} // namespace

JsonValue measureNodesMemory(SmallSource source, unsigned int numNodes, const std::string& picture)
{
    JsonValue row = measureInSeparateProcess([&] { return measureHere(source, numNodes, picture); });
    row["source"] = getName(source);
    row["nodes"] = numNodes;
    row["kibibytesPerNode"]["read"] = perNode(row["before"], row["read"], numNodes);
    row["kibibytesPerNode"]["drawn"] = perNode(row["before"], row["drawn"], numNodes);
    row["glPerNode"] = glPerNode(row["glBefore"], row["glDrawn"], numNodes);
    const JsonValue& sizes = row["kibibytesPerNode"];
    row["goals"] = JsonValue::createArray(
        {createMemoryGoal("KiB per node read", sizes["read"]["resident"].toNumber(), READ_GOAL),
         createMemoryGoal("KiB per node drawn", sizes["drawn"]["resident"].toNumber(), DRAWN_GOAL)});
    return row;
}

void printNodesMemory(const JsonValue& document)
{
    fmt::print("| nodes | KiB per node | resident | heap | verdict |\n|---|---|---|---|---|\n");
    for (const JsonValue& row : document["rows"].getElements())
        for (const char* state : {"read", "drawn"})
        {
            const JsonValue& size = row["kibibytesPerNode"][state];
            const JsonValue& goal = row["goals"].getElements()[state == std::string("read") ? 0 : 1];
            fmt::print("| {} of {} | {} | {:.0f} | {:.0f} | {}, goal {:.0f} |\n", row["nodes"].toInteger(),
                       row["source"].toText(), state, size["resident"].toNumber(), size["heap"].toNumber(),
                       goal["reached"].toBoolean() ? "reached" : "MISSED", goal["goal"].toNumber());
        }
    fmt::print("\n| GL objects per node | buffers | KiB | textures | KiB |\n|---|---|---|---|---|\n");
    for (const JsonValue& row : document["rows"].getElements())
    {
        const JsonValue& gl = row["glPerNode"];
        fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", row["source"].toText(), gl["buffers"].toNumber(),
                   gl["bufferKibibytes"].toNumber(), gl["textures"].toNumber(), gl["textureKibibytes"].toNumber());
    }
}

} // namespace osgLego
