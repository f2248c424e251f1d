#include "BenchMeshes.h"

#include <osgLego/flattening/SceneTriangles.h>

#include <common/RacingCar.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/NodeVisitor>
#include <osg/ShapeDrawable>
#include <osgDB/ReadFile>

namespace osgLego
{

namespace
{

namespace fs = std::filesystem;

/** Gives every vertex a colour according to its position in the bounds of its geometry. */
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
        const osg::Vec3 size = bounds._max - bounds._min;
        const auto place = [](float offset, float side) { return side > 0.0f ? offset / side : 0.0f; };
        for (const osg::Vec3& position : *positions)
        {
            const osg::Vec3 offset = position - bounds._min;
            colors->push_back(
                osg::Vec4(place(offset.x(), size.x()), place(offset.y(), size.y()), place(offset.z(), size.z()), 1.0f));
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

/** Remove the last ",up=" and return its value; empty if there is none. */
std::string takeUpAxis(std::string& text)
{
    constexpr std::string_view KEY = ",up=";
    const auto place = text.rfind(KEY);
    if (place == std::string::npos) return {};
    const std::string value = text.substr(place + KEY.size());
    text.resize(place);
    if (value != "y" && value != "z")
        throw std::runtime_error("bad value '" + value + "' for up in '" + text + "'; expected y or z");
    return value;
}

osg::ref_ptr<osg::Node> createStair()
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (int step = 0; step < 10; ++step)
    {
        const auto height = static_cast<float>(step + 1);
        osg::ref_ptr<osg::ShapeDrawable> box = new osg::ShapeDrawable(new osg::Box(
            osg::Vec3(5.0f, static_cast<float>(step) + 0.5f, 0.5f * height), 9.98f, 0.98f, height - 0.02f));
        box->setColor(osg::Vec4(0.8f, 0.8f, 0.8f, 1.0f));
        geode->addDrawable(box);
    }
    return geode;
}

osg::ref_ptr<osg::Node> readNode(const MeshSource& source)
{
    if (source.path == "car") return createRacingCar();
    if (source.path == "stair") return createStair();
    osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(source.path);
    if (!node) throw std::runtime_error("can't read '" + source.path + "'");
    return node;
}

} // namespace

MeshSource MeshSource::parse(const std::string& text)
{
    MeshSource source{"", text};
    if (takeUpAxis(source.path) == "y") source.upAxis = UpAxis::Y;
    if (const auto place = source.path.find('='); place != std::string::npos)
    {
        source.name = source.path.substr(0, place);
        source.path.erase(0, place + 1);
    }
    if (source.path.empty()) throw std::runtime_error("'" + text + "' names no mesh; expected a path, or 'car'");
    if (source.name.empty()) source.name = fs::path(source.path).stem().string();
    if (source.isFile() && !fs::exists(source.path))
        throw std::runtime_error("'" + source.path + "': there is no such file");
    return source;
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
    sources.insert(sources.begin(), MeshSource());
    return sources;
}

MeshSource findBunny(const std::string& folder)
{
    const std::string path = folder + "/bunny.ply";
    return fs::exists(path) ? MeshSource{"bunny", path, UpAxis::Y} : MeshSource();
}

osg::ref_ptr<osg::Node> readMesh(const MeshSource& source)
{
    osg::ref_ptr<osg::Node> node = readNode(source);
    const osg::ref_ptr<const SceneTriangles> scene = SceneTriangles::create(*node);
    if (scene->getNumTriangles() == 0) throw std::runtime_error("'" + source.path + "' has no triangles to legolize");
    if (source.isFile() && !hasColors(*scene))
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
    mesh.settings.grid.resolution = resolution;
    mesh.settings.grid.upAxis = source.upAxis;
    mesh.triangles = GridTriangles::create(*SceneTriangles::create(node), mesh.settings);
    return mesh;
}

} // namespace osgLego
