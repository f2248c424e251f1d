#include "MotionTimes.h"

#include "BenchScene.h"
#include "Spread.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <oneapi/tbb/info.h>
#include <osg/ComputeBoundsVisitor>
#include <osg/Geometry>
#include <osg/NodeVisitor>

namespace osgLego
{

namespace
{

constexpr double SETS_GOAL = 15.0; // per second
constexpr double RATE_GOAL = 0.7;  // of the still model's frame rate

/** A mesh that bends from side to side. */
class SwayingMesh : public osg::NodeVisitor
{
public:
    explicit SwayingMesh(const MeshSource& source) :
        osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), _up(source.upAxis == UpAxis::Y ? 1 : 2),
        _node(osg::clone(readMesh(source).get(), osg::CopyOp::DEEP_COPY_ALL))
    {
        osg::ComputeBoundsVisitor bounds;
        _node->accept(bounds);
        _bottom = bounds.getBoundingBox()._min[_up];
        _height = bounds.getBoundingBox()._max[_up] - _bottom;
        _node->accept(*this);
    }

    void apply(osg::Geometry& geometry) override
    {
        auto* vertices = dynamic_cast<osg::Vec3Array*>(geometry.getVertexArray());
        if (!vertices) throw std::runtime_error("a mesh that sways has vertices of three floats");
        _parts.push_back({&geometry, vertices, osg::clone(vertices, osg::CopyOp::DEEP_COPY_ALL)});
    }

    osg::Node& getNode() { return *_node; }

    /** @param seconds since the mesh was upright. */
    void bend(double seconds)
    {
        constexpr double PERIOD = 2.0; // seconds
        constexpr double REACH = 0.1;  // of the height
        const double reach = REACH * _height * std::sin(2.0 * std::numbers::pi * seconds / PERIOD);
        for (const Part& part : _parts)
        {
            for (std::size_t index = 0; index < part.vertices->size(); ++index)
            {
                const osg::Vec3& upright = (*part.upright)[index];
                const double above = (upright[_up] - _bottom) / _height;
                (*part.vertices)[index].x() = upright.x() + static_cast<float>(reach * above * above);
            }
            part.vertices->dirty();
            part.geometry->dirtyBound();
        }
    }

private:
    struct Part
    {
        osg::ref_ptr<osg::Geometry> geometry;
        osg::ref_ptr<osg::Vec3Array> vertices;
        osg::ref_ptr<osg::Vec3Array> upright;
    };

    int _up;
    osg::ref_ptr<osg::Node> _node;
    double _bottom = 0.0;
    double _height = 1.0;
    std::vector<Part> _parts;
};

struct Rates
{
    double frames = 0.0; // per second
    double sets = 0.0;   // per second
};

/** Draw frames for some seconds. @param change called before each frame, with the seconds since the start. */
template <typename Change>
Rates drawFor(double seconds, FrameViewer& viewer, const LegoNode& lego, const Change& change)
{
    using Clock = std::chrono::steady_clock;
    const unsigned int numBefore = lego.getStatistics(viewer.getContextID()).numLegolizations;
    const Clock::time_point start = Clock::now();
    double passed = 0.0;
    unsigned int numFrames = 0;
    for (; passed < seconds; ++numFrames)
    {
        change(passed);
        viewer.timeFrame();
        passed = std::chrono::duration<double>(Clock::now() - start).count();
    }
    const unsigned int numSets = lego.getStatistics(viewer.getContextID()).numLegolizations - numBefore;
    return {numFrames / passed, numSets / passed};
}

JsonValue createRateGoal(const char* what, double figure, double goal)
{
    return {{"what", what}, {"figure", figure}, {"goal", goal}, {"reached", figure >= goal}};
}

} // namespace

JsonValue measureMotion(const MeshSource& mesh, const std::string& text, unsigned int numTurns, double seconds)
{
    BenchScene scene(mesh, 1);
    std::string error;
    if (!LegoSettings::parse(text + (mesh.upAxis == UpAxis::Y ? ",anchor=first,up=y" : ",anchor=first,up=z"),
                             scene.settings, error))
        throw std::runtime_error(error);
    SwayingMesh swaying(mesh);
    const osg::ref_ptr<LegoNode> lego = new LegoNode(scene.settings);
    lego->addChild(&swaying.getNode());
    FrameViewer viewer({640, 480});
    viewer.show(*lego, scene);
    viewer.timeFrame("first");
    checkBricks(*lego, viewer);
    checkPicture(*viewer.read());
    std::vector<double> sets;
    std::vector<double> moving;
    std::vector<double> still;
    std::vector<double> ratios;
    for (unsigned int turn = 0; turn < numTurns; ++turn)
    {
        const Rates rates = drawFor(seconds, viewer, *lego, [&](double passed) { swaying.bend(passed); });
        sets.push_back(rates.sets);
        moving.push_back(rates.frames);
        swaying.bend(0.0);
        while (!lego->isLegolized(viewer.getContextID()))
            viewer.timeFrame();
        still.push_back(drawFor(0.5 * seconds, viewer, *lego, [](double) {}).frames);
        ratios.push_back(moving.back() / still.back());
    }
    JsonValue row{{"mesh", mesh.name},
                  {"settings", text},
                  {"cores", oneapi::tbb::info::default_concurrency()},
                  {"setsPerSecond", createSpread(std::move(sets))},
                  {"framesPerSecond", createSpread(std::move(moving))},
                  {"stillFramesPerSecond", createSpread(std::move(still))},
                  {"ratio", createSpread(std::move(ratios))}};
    row["goals"].append(createRateGoal("brick sets per second", row["setsPerSecond"]["median"].toNumber(), SETS_GOAL));
    row["goals"].append(
        createRateGoal("frame rate / that of the still model", row["ratio"]["median"].toNumber(), RATE_GOAL));
    return row;
}

} // namespace osgLego
