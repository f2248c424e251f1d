#include "FrameBench.h"

#include "BenchView.h"

#include <offscreen/OffscreenContext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <osg/PolygonOffset>
#include <osg/Timer>
#include <osgDB/WriteFile>

namespace osgLego
{

namespace
{

constexpr int WIDTH = 1280;
constexpr int HEIGHT = 720;
constexpr const char* SHADER_PATH = "OSGLEGO_SHADER_PATH";

/** The same bricks twice, each under what draws them, before one camera. */
class FramePair
{
public:
    FramePair(const BenchScene& scene, FrameLook look) : _look(look)
    {
        std::string error;
        _context = createOffscreenContext(WIDTH, HEIGHT, error);
        if (!_context) throw std::runtime_error(error);
        const osg::ref_ptr<osg::Node> mesh = createBenchMesh(scene.mesh);
        // Of bricks that the passes found no blocks are known, which could be left out as a whole.
        LegoSettings reference = scene.settings;
        reference.device = Device::GPU;
        _ways = {createWay(*mesh, reference, look), createWay(*mesh, scene.settings, look)};
        for (const osg::ref_ptr<osg::Group>& way : _ways)
            _root->addChild(way);
        // Geometry that is offset is drawn by triangles, not by rays; this offset moves nothing.
        _ways[0]->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(0.0f, 0.0f));
        osg::Camera& camera = *_viewer.getCamera();
        camera.setGraphicsContext(_context);
        camera.setViewport(0, 0, WIDTH, HEIGHT);
        camera.setDrawBuffer(GL_BACK);
        camera.setReadBuffer(GL_BACK);
        camera.setClearColor(osg::Vec4(0.0f, 0.0f, 0.2f, 1.0f));
        camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
        _viewer.setReleaseContextAtEndOfFrameHint(false);
        _viewer.setSceneData(_root);
        placeCamera(camera, scene, _root->getBound(), static_cast<double>(WIDTH) / HEIGHT);
        makePrograms();
    }

    /** Milliseconds of a frame, the last command finished. */
    double draw(std::size_t way)
    {
        for (std::size_t other = 0; other < _ways.size(); ++other)
            _ways[other]->setNodeMask(other == way ? ~0u : 0u);
        const osg::Timer_t start = osg::Timer::instance()->tick();
        _viewer.frame();
        glFinish();
        if (_look == FrameLook::BUFFER)
            return dynamic_cast<AmbientOcclusionScene&>(*_ways[way])
                .getTimes(_context->getState()->getContextID())
                .geometry;
        return osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    }

    osg::ref_ptr<osg::Image> read() const
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->readPixels(0, 0, WIDTH, HEIGHT, GL_RGB, GL_UNSIGNED_BYTE);
        return image;
    }

private:
    static osg::ref_ptr<osg::Group> createWay(osg::Node& mesh, LegoSettings settings, FrameLook look)
    {
        settings.look = look == FrameLook::PLAIN ? Look::PLAIN : Look::FULL;
        osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
        lego->addChild(&mesh);
        if (look == FrameLook::PLAIN || look == FrameLook::FULL) return lego;
        osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
        scene->setTiming(look == FrameLook::BUFFER);
        scene->addChild(lego);
        return scene;
    }

    /** Programs are made in the first frame: those of the reference from its own shaders. */
    void makePrograms()
    {
        const char* path = std::getenv(SHADER_PATH);
        const std::string former = path ? path : "";
        setenv(SHADER_PATH, OSGLEGO_REFERENCE_SHADERS, 1);
        draw(0);
        if (path)
            setenv(SHADER_PATH, former.c_str(), 1);
        else
            unsetenv(SHADER_PATH);
        draw(1);
    }

    FrameLook _look;
    osgViewer::Viewer _viewer; // closes the context when it goes
    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    std::array<osg::ref_ptr<osg::Group>, 2> _ways; // the reference, and what is compared with it
};

FrameDifference differenceOf(const osg::Image& a, const osg::Image& b)
{
    FrameDifference result;
    double squares = 0.0;
    for (unsigned int row = 0; row < HEIGHT; ++row)
        for (unsigned int column = 0; column < WIDTH; ++column)
        {
            const unsigned char* first = a.data(column, row);
            const unsigned char* second = b.data(column, row);
            int largest = 0;
            for (int channel = 0; channel < 3; ++channel)
            {
                const int difference = std::abs(first[channel] - second[channel]);
                largest = std::max(largest, difference);
                squares += difference * difference;
            }
            result.largest = std::max(result.largest, largest);
            if (largest > 2) ++result.numPixels;
            if (first[0] != 0 || first[1] != 0 || first[2] != 51) ++result.numDrawn;
        }
    result.rootMeanSquare = std::sqrt(squares / (3.0 * WIDTH * HEIGHT));
    return result;
}

constexpr double GOAL = 4.0; // as fast as the reference, so many times

void printComparison(const BenchScene& scene, const char* look, const FrameComparison& comparison)
{
    const FrameDifference& difference = comparison.difference;
    fmt::print("| {:6} | {:3} | {:7} | {:9} | {:6.1f} ({:.1f} to {:.1f}) | {:6.1f} ({:.1f} to {:.1f}) | {:5.2f} | {:3} "
               "| {:6.3f} | {:6} of {:6} | {} | {} |\n",
               std::filesystem::path(scene.mesh).stem().string(), scene.settings.resolution, scene.name, look,
               comparison.reference.median, comparison.reference.lowerQuartile, comparison.reference.upperQuartile,
               comparison.present.median, comparison.present.lowerQuartile, comparison.present.upperQuartile,
               comparison.reference.median / comparison.present.median, difference.largest, difference.rootMeanSquare,
               difference.numPixels, difference.numDrawn, difference.isSame() ? "same" : "different",
               comparison.reference.median >= GOAL * comparison.present.median ? "yes" : "no");
    std::fflush(stdout);
}

/** The places that a mesh is looked at from, at one resolution. */
std::vector<BenchScene> createViews(const std::string& modelFolder, unsigned int resolution)
{
    BenchScene scene;
    const std::string bunny = modelFolder + "/bunny.ply";
    if (std::filesystem::exists(bunny))
    {
        scene.mesh = bunny;
        scene.settings.upAxis = UpAxis::Y;
    }
    scene.settings.resolution = resolution;
    const auto from = [&scene](const char* name, double elevation, double distance)
    {
        BenchScene view = scene;
        view.name = name;
        view.elevation = elevation;
        view.distance = distance;
        return view;
    };
    std::vector<BenchScene> views{from("above", 25.0, 3.5)};
    if (resolution == 128)
        for (const BenchScene& view : {from("below", -35.0, 3.5), from("near", 25.0, 1.3), from("far", 25.0, 14.0)})
            views.push_back(view);
    return views;
}

constexpr std::array<std::pair<FrameLook, const char*>, 4> LOOKS{{{FrameLook::PLAIN, "plain"},
                                                                  {FrameLook::FULL, "full"},
                                                                  {FrameLook::BUFFER, "buffer"},
                                                                  {FrameLook::OCCLUSION, "occlusion"}}};

} // namespace

bool FrameDifference::isSame() const
{
    return rootMeanSquare < 1.0 && numPixels * 100 <= numDrawn;
}

FrameComparison compareFrames(const BenchScene& scene, FrameLook look, int numFrames, const std::string& pictureName)
{
    FramePair pair(scene, look);
    std::array<osg::ref_ptr<osg::Image>, 2> pictures;
    std::array<std::vector<double>, 2> times;
    for (int frame = 0; frame < numFrames; ++frame)
        for (std::size_t way = 0; way < 2; ++way)
        {
            times[way].push_back(pair.draw(way));
            if (frame == 0) pictures[way] = pair.read();
        }
    if (!pictureName.empty())
    {
        osgDB::writeImageFile(*pictures[0], pictureName + "-reference.png");
        osgDB::writeImageFile(*pictures[1], pictureName + "-present.png");
    }
    return {Spread::create(times[0]), Spread::create(times[1]), differenceOf(*pictures[0], *pictures[1])};
}

void printFrames(const std::string& modelFolder, int numFrames, const std::string& pictureFolder)
{
    fmt::print(
        "Milliseconds a frame at {} x {}, medians and quartiles of {}: the reference, every face and stud drawn, "
        "of 16 sides; and the present way\n\n",
        WIDTH, HEIGHT, numFrames);
    fmt::print(
        "| mesh | N | view | look | reference | present | ratio | largest of 255 | RMSE | pixels off by more than 2 "
        "| picture | 4 times as fast |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const unsigned int resolution : {64u, 128u, 256u})
        for (const BenchScene& view : createViews(modelFolder, resolution))
            for (const auto& [look, name] : LOOKS)
            {
                std::string picture;
                if (!pictureFolder.empty())
                    picture = fmt::format("{}/{}-{}-{}", pictureFolder, resolution, view.name, name);
                printComparison(view, name, compareFrames(view, look, numFrames, picture));
            }
}

} // namespace osgLego
