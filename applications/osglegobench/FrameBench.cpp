#include "FrameBench.h"

#include "BenchView.h"
#include "FrameResults.h"
#include "FrameViewer.h"
#include "ReferenceShaders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>
#include <osg/Timer>
#include <osgDB/WriteFile>

namespace osgLego
{

namespace
{

/** The same bricks twice, each under what draws them, before one camera. */
class FramePair
{
public:
    FramePair(const BenchScene& scene, FrameLook look, const glm::ivec2& size) : _look(look), _viewer(size)
    {
        const osg::ref_ptr<osg::Node> mesh = createBenchMesh(scene.mesh);
        // Of bricks that the passes found no blocks are known, which could be left out as a whole.
        LegoSettings reference = scene.settings;
        reference.device = Device::GPU;
        _ways = {createWay(*mesh, reference, look), createWay(*mesh, scene.settings, look)};
        for (const osg::ref_ptr<osg::Group>& way : _ways)
            _root->addChild(way);
        drawByTriangles(*_ways[0]);
        _viewer.show(*_root, scene);
        makePrograms();
    }

    /** Milliseconds of a frame, the last command finished. */
    double draw(std::size_t way)
    {
        for (std::size_t other = 0; other < _ways.size(); ++other)
            _ways[other]->setNodeMask(other == way ? ~0u : 0u);
        const osg::Timer_t start = osg::Timer::instance()->tick();
        _viewer.drawFrame();
        glFinish();
        if (_look == FrameLook::BUFFER)
            return dynamic_cast<AmbientOcclusionScene&>(*_ways[way]).getTimes(_viewer.getContextID()).geometry;
        return osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    }

    osg::ref_ptr<osg::Image> read() const { return _viewer.read(); }

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
        {
            const ReferenceShaders reference;
            draw(0);
        }
        draw(1);
    }

    FrameLook _look;
    FrameViewer _viewer;
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    std::array<osg::ref_ptr<osg::Group>, 2> _ways; // the reference, and what is compared with it
};

FrameDifference differenceOf(const osg::Image& a, const osg::Image& b)
{
    FrameDifference result;
    double squares = 0.0;
    for (int row = 0; row < a.t(); ++row)
        for (int column = 0; column < a.s(); ++column)
        {
            const unsigned char* first = a.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            const unsigned char* second = b.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
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
    result.rootMeanSquare = std::sqrt(squares / (3.0 * a.s() * a.t()));
    return result;
}

/** The places that a mesh is looked at from, at one resolution. */
std::vector<BenchScene> createViews(const MeshSource& source, unsigned int resolution)
{
    const BenchScene scene = createBenchScene(source, resolution);
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

FrameComparison compareFrames(const BenchScene& scene, FrameLook look, unsigned int numFrames, const glm::ivec2& size,
                              const std::string& pictureName)
{
    FramePair pair(scene, look, size);
    std::array<osg::ref_ptr<osg::Image>, 2> pictures;
    std::array<std::vector<double>, 2> times;
    for (unsigned int frame = 0; frame < numFrames; ++frame)
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

FrameResults measureFrames(const FrameOptions& options)
{
    FrameResults results;
    results.environment = BenchEnvironment::find(FrameViewer(options.size).getContext());
    results.size = options.size;
    results.numFrames = options.numFrames;
    const std::string& mesh = options.mesh.name;
    for (const unsigned int resolution : options.resolutions)
        for (const BenchScene& view : createViews(options.mesh, resolution))
            for (const auto& [look, name] : LOOKS)
            {
                fmt::print(stderr, "drawing {} at {} from {}, {}\n", mesh, resolution, view.name, name);
                std::string picture;
                if (!options.pictureFolder.empty())
                    picture = fmt::format("{}/{}-{}-{}", options.pictureFolder, resolution, view.name, name);
                results.rows.push_back({mesh, resolution, view.name, name,
                                        compareFrames(view, look, options.numFrames, options.size, picture)});
            }
    const unsigned int resolution = options.resolutions.front();
    fmt::print(stderr, "drawing {} at {}, nothing changing\n", mesh, resolution);
    results.unchangedMesh = fmt::format("{} at {}", mesh, resolution);
    results.unchanged = countInUnchangedFrames(createViews(options.mesh, resolution).front(), options.size);
    return results;
}

} // namespace osgLego
