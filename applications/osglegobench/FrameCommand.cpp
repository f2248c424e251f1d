#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "BenchScene.h"
#include "Commands.h"
#include "ReferenceShaders.h"
#include "Spread.h"

#include <osgLego/AmbientOcclusionScene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

struct FrameOptions : BenchOptions
{
    BenchRuns runs{5, 0};
    std::string drawing = "auto"; //!< of the present way

    glm::ivec2 getSize() const { return isQuick ? glm::ivec2(160, 90) : glm::ivec2(1280, 720); }
    void apply(LegoSettings& settings) const
    {
        std::string error;
        if (!LegoSettings::parse("drawing=" + drawing, settings, error)) throw std::runtime_error(error);
    }
};

/** "plain" and "full" are looks of LegoSettings; "occlusion" is the full look under an AmbientOcclusionScene, and
 * "buffer" only its bricks, without the following passes. */
constexpr std::array LOOKS{"plain", "full", "buffer", "occlusion"};

/** The same bricks twice in front of one camera: drawn with the reference shaders, and with the current ones. */
class FramePair
{
public:
    FramePair(const BenchScene& scene, const std::string& look, const glm::ivec2& size) :
        _isBuffer(look == "buffer"), _viewer(size)
    {
        BenchScene reference = scene;
        reference.settings.voxelization.device = Device::GPU;
        reference.settings.view.drawing = Drawing::TRIANGLES;
        _ways = {createWay(reference, look), createWay(scene, look)};
        for (const osg::ref_ptr<osg::Group>& way : _ways)
            _root->addChild(way);
        // A stencil test, which always passes here, prevents the drawing from skipping back-facing blocks of bricks.
        _ways[0]->getOrCreateStateSet()->setMode(GL_STENCIL_TEST, osg::StateAttribute::ON);
        _viewer.show(*_root, scene);
        {
            const ReferenceShaders shaders; // programs are created in the first frame
            draw(0);
        }
        draw(1);
    }

    /** @return milliseconds of a frame. */
    double draw(std::size_t way)
    {
        for (std::size_t other = 0; other < _ways.size(); ++other)
            _ways[other]->setNodeMask(other == way ? ~0u : 0u);
        const double time = _viewer.timeFrame();
        if (!_isBuffer) return time;
        return dynamic_cast<AmbientOcclusionScene&>(*_ways[way]).getTimes(_viewer.getContextID()).geometry;
    }

    osg::ref_ptr<osg::Image> read() const { return _viewer.read(); }

private:
    static osg::ref_ptr<osg::Group> createWay(BenchScene scene, const std::string& look)
    {
        scene.settings.view.look = look == "plain" ? Look::PLAIN : Look::FULL;
        // The reference shaders know no occlusion by the grid.
        osg::ref_ptr<LegoNode> lego = scene.createLego(BrickOcclusion::SCREEN);
        if (look == "plain" || look == "full") return lego;
        osg::ref_ptr<AmbientOcclusionScene> occlusion = new AmbientOcclusionScene;
        occlusion->setTiming(look == "buffer");
        occlusion->addChild(lego);
        return occlusion;
    }

    bool _isBuffer;
    FrameViewer _viewer;
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    std::array<osg::ref_ptr<osg::Group>, 2> _ways; // the reference, and the current drawing
};

/** The difference of two pictures in levels of 255. They count as equal if the difference is invisible: the mean is
 * less than one level, and at most one in a hundred of the pixels covered by bricks differs by more than two. */
JsonValue compare(const osg::Image& a, const osg::Image& b)
{
    int largest = 0;
    double squares = 0.0;
    std::size_t numPixels = 0;
    std::size_t numDrawn = 0;
    for (int row = 0; row < a.t(); ++row)
        for (int column = 0; column < a.s(); ++column)
        {
            const unsigned char* first = a.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            const unsigned char* second = b.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            int most = 0;
            for (int channel = 0; channel < 3; ++channel)
            {
                const int difference = std::abs(first[channel] - second[channel]);
                most = std::max(most, difference);
                squares += difference * difference;
            }
            largest = std::max(largest, most);
            if (most > 2) ++numPixels;
            if (first[0] != 0 || first[1] != 0 || first[2] != 51) ++numDrawn; // the viewer's background
        }
    const double rootMeanSquare = std::sqrt(squares / (3.0 * a.s() * a.t()));
    return {{"largest", largest},
            {"rootMeanSquare", rootMeanSquare},
            {"pixels", numPixels},
            {"drawnPixels", numDrawn},
            {"same", rootMeanSquare < 1.0 && numPixels * 100 <= numDrawn}};
}

/** Draw frames alternately with both. */
JsonValue compareWays(const BenchScene& scene, const std::string& view, const std::string& look,
                      const FrameOptions& options)
{
    fmt::print(stderr, "drawing {} at {} from {}, {}\n", scene.mesh.name, scene.settings.grid.resolution, view, look);
    FramePair pair(scene, look, options.getSize());
    std::array<osg::ref_ptr<osg::Image>, 2> pictures;
    std::array<std::vector<double>, 2> times;
    for (unsigned int run = 0; run < options.runs.numWarmUps + options.runs.numRuns; ++run)
        for (std::size_t way = 0; way < 2; ++way)
        {
            const double time = pair.draw(way);
            if (run >= options.runs.numWarmUps) times[way].push_back(time);
            if (run == 0) pictures[way] = pair.read();
        }
    return {{"mesh", scene.mesh.name},
            {"resolution", scene.settings.grid.resolution},
            {"view", view},
            {"look", look},
            {"referenceMilliseconds", createSpread(times[0])},
            {"presentMilliseconds", createSpread(times[1])},
            {"difference", compare(*pictures[0], *pictures[1])}};
}

/** The views of a mesh at one resolution, by name. */
std::vector<std::pair<std::string, BenchScene>> createViews(const MeshSource& source, unsigned int resolution)
{
    std::vector<std::pair<std::string, BenchScene>> views;
    const auto add = [&](const char* name, double elevation, double distance)
    {
        views.emplace_back(name, BenchScene(source, resolution));
        views.back().second.elevation = elevation;
        views.back().second.distance = distance;
    };
    add("above", 25.0, 3.5);
    if (resolution != 128) return views;
    add("below", -35.0, 3.5);
    add("near", 25.0, 1.3);
    add("far", 25.0, 14.0);
    return views;
}

void runFrame(const FrameOptions& options)
{
    const MeshSource source = options.getMesh();
    JsonValue document = createDocument("frame", *createBenchContext());
    document["width"] = options.getSize().x;
    document["height"] = options.getSize().y;
    document["frames"] = options.runs.numRuns;
    document["drawing"] = options.drawing;
    for (const unsigned int resolution : options.getResolutions({16}, {64, 128, 256}))
        for (auto& [view, scene] : createViews(source, resolution))
        {
            options.apply(scene.settings);
            for (const char* look : LOOKS)
                document["rows"].append(compareWays(scene, view, look, options));
        }
    options.write(document);
}

} // namespace

void addFrameCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add(
        "frame", "Drawing: the time of a frame, and its picture, beside a reference that draws every face and stud");
    const auto options = std::make_shared<FrameOptions>();
    options->addTo(command, "64,128,256");
    options->runs.addTo(command);
    command.addChoice("--drawing", options->drawing, "The way to compare: auto, triangles, splats (auto)",
                      {"auto", "triangles", "splats"});
    command.setRun([options] { runFrame(*options); });
}

} // namespace osgLego
