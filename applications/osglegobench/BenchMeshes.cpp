#include "BenchMeshes.h"

#include <common/RacingCar.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <osg/Geometry>
#include <osg/NodeVisitor>
#include <osgDB/ReadFile>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

/** Gives every vertex a colour by its place in its geometry's bounds. */
class PlaceColorizer : public osg::NodeVisitor
{
public:
    PlaceColorizer() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    void apply(osg::Geometry& geometry) override
    {
        const auto* positions = dynamic_cast<const osg::Vec3Array*>(geometry.getVertexArray());
        if (!positions) return;
        const osg::BoundingBox& bounds = geometry.getBoundingBox();
        osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(osg::Array::BIND_PER_VERTEX);
        for (const osg::Vec3& position : *positions)
        {
            osg::Vec4 color(0.0f, 0.0f, 0.0f, 1.0f);
            for (int axis = 0; axis < 3; ++axis)
            {
                const float side = std::max(bounds._max[axis] - bounds._min[axis], 1e-30f);
                color[static_cast<unsigned int>(axis)] =
                    std::clamp((position[axis] - bounds._min[axis]) / side, 0.0f, 1.0f);
            }
            colors->push_back(color);
        }
        geometry.setColorArray(colors);
    }
};

bool hasColors(const SceneTriangles& scene)
{
    const glm::vec3 first = scene.getBatches().front().vertices.front().color;
    return std::any_of(scene.getBatches().begin(), scene.getBatches().end(),
                       [&first](const SceneBatch& batch)
                       {
                           return batch.texture ||
                                  std::any_of(batch.vertices.begin(), batch.vertices.end(),
                                              [&first](const SceneVertex& vertex) { return vertex.color != first; });
                       });
}

/** What stands behind the last ",up=", which is cut off; empty when there is none. */
std::string takeUpAxis(std::string& text)
{
    constexpr std::string_view KEY = ",up=";
    const auto place = text.rfind(KEY);
    if (place == std::string::npos) return {};
    const std::string value = text.substr(place + KEY.size());
    text.resize(place);
    if (value != "y" && value != "z")
        throw std::runtime_error("bad value '" + value + "' for up in '" + text + "'; allowed: y, z");
    return value;
}

} // namespace

MeshSource MeshSource::parse(const std::string& text)
{
    MeshSource source;
    source.path = text;
    if (takeUpAxis(source.path) == "y") source.upAxis = UpAxis::Y;
    if (const auto place = source.path.find('='); place != std::string::npos)
    {
        source.name = source.path.substr(0, place);
        source.path.erase(0, place + 1);
    }
    if (source.path.empty()) throw std::runtime_error("'" + text + "' names no mesh; allowed: a path, or 'car'");
    if (source.path == "car") source.path.clear();
    if (source.name.empty()) source.name = source.path.empty() ? "car" : fs::path(source.path).stem().string();
    if (!source.path.empty() && !fs::exists(source.path))
        throw std::runtime_error("'" + source.path + "': there is no such file");
    return source;
}

std::string MeshSource::toString() const
{
    return name + "=" + (path.empty() ? "car" : path) + (upAxis == UpAxis::Y ? ",up=y" : ",up=z");
}

std::vector<MeshSource> findMeshSources(const std::string& folder)
{
    std::vector<MeshSource> sources;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    {
        const fs::path& path = entry.path();
        if (path.extension() == ".ply") sources.push_back({path.stem().string(), path.string(), UpAxis::Y});
        if (path.extension() == ".dae") sources.push_back({path.stem().string(), path.string(), UpAxis::Z});
    }
    std::sort(sources.begin(), sources.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    sources.insert(sources.begin(), {"car", "", UpAxis::Z});
    return sources;
}

MeshSource findBunny(const std::string& folder)
{
    const std::string path = folder + "/bunny.ply";
    return fs::exists(path) ? MeshSource{"bunny", path, UpAxis::Y} : MeshSource{"car", "", UpAxis::Z};
}

osg::ref_ptr<osg::Node> readMesh(const MeshSource& source)
{
    osg::ref_ptr<osg::Node> node = source.path.empty() ? createRacingCar() : osgDB::readRefNodeFile(source.path);
    if (!node) throw std::runtime_error("can't read '" + source.path + "'");
    const osg::ref_ptr<const SceneTriangles> scene = SceneTriangles::create(*node);
    if (scene->getNumTriangles() == 0) throw std::runtime_error("'" + source.path + "' has no triangles to legolize");
    if (!hasColors(*scene))
    {
        PlaceColorizer colorizer;
        node->accept(colorizer);
    }
    return node;
}

BenchMesh createBenchMesh(const MeshSource& source, osg::Node& node, unsigned int resolution)
{
    BenchMesh mesh;
    mesh.name = source.name;
    mesh.node = &node;
    mesh.settings.resolution = resolution;
    mesh.settings.upAxis = source.upAxis;
    mesh.scene = SceneTriangles::create(node);
    mesh.triangles = GridTriangles::create(*mesh.scene, mesh.settings);
    return mesh;
}

} // namespace osgLego
