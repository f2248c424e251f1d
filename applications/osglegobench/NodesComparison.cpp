#include "NodesComparison.h"

#include "ResidentMemory.h"
#include "SeparateProcess.h"
#include "Spread.h"

#include <osgLego/AmbientOcclusionScene.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <osg/ComputeBoundsVisitor>
#include <osg/MatrixTransform>

namespace osgLego
{

namespace
{

constexpr double FIRST_FRAME_GOAL = 3.0; // times that of one node
constexpr double MEMORY_GOAL = 300.0;    // MiB
constexpr double TRAVERSAL_GOAL = 20.0;  // microseconds per node and frame
constexpr double FRAME_GOAL = 1.5;       // times that of one node with the same bricks

/** A mesh in many places side by side, at multiples of the size of a cell, so that it has the same bricks in each. */
class MeshField
{
public:
    MeshField(const BenchScene& scene, unsigned int numPlaces) :
        _scene(scene), _mesh(readMesh(scene.mesh)), _numPlaces(numPlaces)
    {
        osg::ComputeBoundsVisitor bounds;
        _mesh->accept(bounds);
        const osg::Vec3 extent = bounds.getBoundingBox()._max - bounds.getBoundingBox()._min;
        const double longest = std::max({extent.x(), extent.y(), extent.z()});
        const unsigned int resolution = scene.settings.grid.resolution;
        _pitch = longest / resolution;
        _step = (resolution + 3) * _pitch;
        _numAcross = static_cast<unsigned int>(std::ceil(std::sqrt(numPlaces)));
        _scene.settings.grid.resolution = LegoSettings().grid.resolution; // the pitch replaces it
        _scene.settings.grid.cellPitch = _pitch;
        _scene.settings.grid.origin = glm::dvec3(bounds.getBoundingBox()._min.x(), bounds.getBoundingBox()._min.y(),
                                                 bounds.getBoundingBox()._min.z());
    }

    /** A node for each place. */
    std::vector<osg::ref_ptr<LegoNode>> createSeparate(osg::Group& root) const
    {
        std::vector<osg::ref_ptr<LegoNode>> nodes;
        for (unsigned int place = 0; place < _numPlaces; ++place)
        {
            nodes.push_back(createLego());
            nodes.back()->addChild(_mesh);
            const osg::ref_ptr<osg::MatrixTransform> transform = createTransform(place);
            transform->addChild(nodes.back());
            root.addChild(transform);
        }
        return nodes;
    }

    /** One node for all places. */
    std::vector<osg::ref_ptr<LegoNode>> createMerged(osg::Group& root) const
    {
        osg::ref_ptr<LegoNode> node = createLego();
        for (unsigned int place = 0; place < _numPlaces; ++place)
        {
            const osg::ref_ptr<osg::MatrixTransform> transform = createTransform(place);
            transform->addChild(_mesh);
            node->addChild(transform);
        }
        root.addChild(node);
        return {node};
    }

private:
    osg::ref_ptr<LegoNode> createLego() const
    {
        osg::ref_ptr<LegoNode> node = new LegoNode(_scene.settings);
        node->setWaiting(true);
        return node;
    }

    osg::ref_ptr<osg::MatrixTransform> createTransform(unsigned int place) const
    {
        const osg::Vec3d across(_step * (place % _numAcross), 0.0, 0.0);
        const unsigned int row = place / _numAcross;
        const double along = _step * row;
        const bool isYUp = _scene.settings.grid.upAxis == UpAxis::Y;
        return new osg::MatrixTransform(
            osg::Matrixd::translate(across + (isYUp ? osg::Vec3d(0.0, 0.0, along) : osg::Vec3d(0.0, along, 0.0))));
    }

    BenchScene _scene;
    osg::ref_ptr<osg::Node> _mesh;
    unsigned int _numPlaces;
    unsigned int _numAcross = 1;
    double _pitch = 1.0;
    double _step = 1.0; // from one place to the next
};

/** Measure frames of nodes below a root. */
JsonValue measureNodes(const std::string& name, osg::Group& root, const std::vector<osg::ref_ptr<LegoNode>>& nodes,
                       const BenchScene& scene, const NodesOptions& options)
{
    constexpr unsigned int NUM_FRAMES_BEFORE = 10; // more than idle passes are kept
    FrameViewer viewer(options.size);
    viewer.show(root, scene);
    const double first = viewer.timeFrame("first");
    checkPicture(*viewer.read());
    std::size_t numBricks = 0;
    for (const osg::ref_ptr<LegoNode>& node : nodes)
    {
        checkBricks(*node, viewer);
        numBricks += node->getStatistics(viewer.getContextID()).numDrawnBricks;
    }
    for (unsigned int frame = 0; frame < NUM_FRAMES_BEFORE; ++frame)
        viewer.drawFrame();
    std::vector<double> frames;
    std::vector<double> updates;
    std::vector<double> culls;
    std::vector<double> draws;
    for (unsigned int frame = 0; frame < options.numFrames; ++frame)
    {
        frames.push_back(viewer.timeFrame());
        const FrameViewer::Traversals traversals = viewer.timeTraversals();
        updates.push_back(traversals.update);
        culls.push_back(traversals.cull);
        draws.push_back(traversals.draw);
    }
    return {{"scene", name},
            {"nodes", nodes.size()},
            {"drawnBricks", numBricks},
            {"firstMilliseconds", first},
            {"mebibytes", readPeakMemory()},
            {"milliseconds", createSpread(frames)},
            {"updateMilliseconds", createSpread(updates)},
            {"cullMilliseconds", createSpread(culls)},
            {"drawMilliseconds", createSpread(draws)}};
}

enum class Arrangement
{
    SEPARATE,
    MERGED
};

JsonValue measureField(const std::string& name, const BenchScene& scene, unsigned int numPlaces,
                       Arrangement arrangement, const NodesOptions& options)
{
    fmt::print(stderr, "drawing {}\n", name);
    return measureInSeparateProcess(
        [&]
        {
            const osg::ref_ptr<osg::Group> root = options.hasOcclusion ? new AmbientOcclusionScene : new osg::Group;
            const MeshField field(scene, numPlaces);
            const auto nodes =
                arrangement == Arrangement::MERGED ? field.createMerged(*root) : field.createSeparate(*root);
            return measureNodes(name, *root, nodes, scene, options);
        });
}

double medianOf(const JsonValue& row, const char* figure)
{
    return row[figure]["median"].toNumber();
}

JsonValue createGoal(const char* what, double figure, double goal)
{
    return {{"what", what}, {"figure", figure}, {"goal", goal}, {"reached", figure <= goal}};
}

} // namespace

JsonValue compareNodes(const BenchScene& scene, const NodesOptions& options)
{
    const JsonValue one = measureField("one node", scene, 1, Arrangement::SEPARATE, options);
    const JsonValue many = measureField(fmt::format("{} nodes", options.numNodes), scene, options.numNodes,
                                        Arrangement::SEPARATE, options);
    const JsonValue merged =
        measureField("one node, same bricks", scene, options.numNodes, Arrangement::MERGED, options);
    const double traversals = medianOf(many, "updateMilliseconds") + medianOf(many, "cullMilliseconds");
    JsonValue result;
    result["rows"] = JsonValue::createArray({one, many, merged});
    result["goals"] = JsonValue::createArray(
        {createGoal("first frame / that of one node",
                    many["firstMilliseconds"].toNumber() / one["firstMilliseconds"].toNumber(), FIRST_FRAME_GOAL),
         createGoal("MiB", many["mebibytes"].toNumber(), MEMORY_GOAL),
         createGoal("microseconds of update and cull per node", 1000.0 * traversals / options.numNodes, TRAVERSAL_GOAL),
         createGoal("frame / that of one node with the same bricks",
                    medianOf(many, "milliseconds") / medianOf(merged, "milliseconds"), FRAME_GOAL)});
    return result;
}

void printNodes(const JsonValue& document)
{
    fmt::print("| scene | bricks | first frame, ms | MiB | frame, ms | update, ms | cull, ms | draw, ms |\n"
               "|---|---|---|---|---|---|---|---|\n");
    for (const JsonValue& row : document["rows"].getElements())
        fmt::print("| {} | {} | {:.0f} | {:.0f} | {:.2f} | {:.3f} | {:.3f} | {:.2f} |\n", row["scene"].toText(),
                   row["drawnBricks"].toInteger(), row["firstMilliseconds"].toNumber(), row["mebibytes"].toNumber(),
                   medianOf(row, "milliseconds"), medianOf(row, "updateMilliseconds"),
                   medianOf(row, "cullMilliseconds"), medianOf(row, "drawMilliseconds"));
    fmt::print("\n| compared | measured | goal | verdict |\n|---|---|---|---|\n");
    for (const JsonValue& goal : document["goals"].getElements())
        fmt::print("| {} | {:.3g} | {:.3g} | {} |\n", goal["what"].toText(), goal["figure"].toNumber(),
                   goal["goal"].toNumber(), goal["reached"].toBoolean() ? "reached" : "MISSED");
}

} // namespace osgLego
