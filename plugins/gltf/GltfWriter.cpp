#include "GltfWriter.h"

#include "GltfPartMesh.h"

#include <common/FiniteMatrix.h>
#include <common/NumberText.h>
#include <osgLego/Palette.h>
#include <osgLego/PartType.h>
#include <osgLego/palette/CieLab.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <utility>

namespace osgLego
{

namespace
{

constexpr const char* INSTANCING = "EXT_mesh_gpu_instancing";
constexpr double ROUGHNESS = 0.3; // of glossy plastic

JsonValue toArray(const glm::dvec3& vector)
{
    return JsonValue::createArray({vector.x, vector.y, vector.z});
}

/** @param matrix for row vectors, whose rows are the columns that glTF writes. */
JsonValue toArray(const osg::Matrixd& matrix)
{
    return JsonValue::createArray(std::vector<JsonValue>(matrix.ptr(), matrix.ptr() + 16));
}

std::string nameOf(const GltfBricks::Shape& shape, const BrickGrid& grid)
{
    const int plates = getCellPlates(grid) * shape.height;
    const bool isReal = plates == 1 || plates == 3;
    const PartType* type =
        isReal ? findPartType(plates == 3 ? PartFamily::BRICK : PartFamily::PLATE, shape.width, shape.length) : nullptr;
    if (type) return type->getName();
    return std::to_string(shape.length) + " x " + std::to_string(shape.width) + " x " + std::to_string(shape.height) +
           " cells";
}

std::string nameOf(const std::array<std::uint8_t, 3>& color)
{
    for (const PaletteColor& known : Palette::getKnownColors())
        if (known.color == color) return known.name;
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", color[0], color[1], color[2]);
    return text.data();
}

osg::Vec3 toOsg(const glm::dvec3& vector)
{
    return {static_cast<float>(vector.x), static_cast<float>(vector.y), static_cast<float>(vector.z)};
}

/** The reason why glTF can't represent a transform, whose axes must be orthogonal; empty if it can. */
std::string findObstacle(const osg::Matrixd& matrix)
{
    constexpr double TOLERANCE = 1e-6;
    const auto axisOf = [&matrix](int row) { return osg::Vec3d(matrix(row, 0), matrix(row, 1), matrix(row, 2)); };
    const bool isAffine = osg::Vec4d(matrix(0, 3), matrix(1, 3), matrix(2, 3), matrix(3, 3)) == osg::Vec4d(0, 0, 0, 1);
    if (!isFinite(matrix)) return "is below a transform that is infinite or not a number; expected finite values";
    if (!isAffine) return "is below a transform that is not affine; expected one without perspective";
    for (int row = 0; row < 3; ++row)
    {
        const osg::Vec3d axis = axisOf(row);
        const osg::Vec3d next = axisOf((row + 1) % 3);
        if (axis.length() == 0.0) return "is below a transform without an inverse; expected one that keeps volumes";
        if (std::abs(axis * next) > TOLERANCE * axis.length() * next.length())
            return "is below a transform that shears it; expected one that keeps right angles";
    }
    return {};
}

void appendWord(std::string& bytes, std::size_t word)
{
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(word >> shift & 0xff);
}

std::string chunkHeader(std::size_t length, const char* type)
{
    std::string header;
    appendWord(header, length);
    return header.append(type, 4);
}

} // namespace

bool GltfWriter::add(const osg::Node& scene, std::string& error)
{
    for (const PlacedLegoNode& placed : findVisibleLegoNodes(scene))
        if (!addPlacement(placed, error)) return false;
    if (_models.empty()) error = "there are no bricks in it; expected a LegoNode, as from MESH.legolize";
    return error.empty();
}

bool GltfWriter::addPlacement(const PlacedLegoNode& placed, std::string& error)
{
    error = findObstacle(placed.toWorld);
    if (error.empty() && _models.count(placed.node) == 0) addModel(*placed.node, error);
    if (!error.empty())
    {
        const std::string& name = placed.node->getName();
        error = (name.empty() ? "the model" : "'" + name + "'") + " " + error;
        return false;
    }
    JsonValue node{{"children", JsonValue::createArray()}};
    if (!placed.node->getName().empty()) node["name"] = placed.node->getName();
    if (!placed.toWorld.isIdentity()) node["matrix"] = toArray(placed.toWorld);
    // A node of glTF has one parent.
    for (const JsonValue& child : _models[placed.node])
        node["children"].append(addNode(child));
    _placements.append(addNode(std::move(node)));
    return true;
}

void GltfWriter::addModel(const LegoNode& node, std::string& error)
{
    const osg::ref_ptr<const BrickModel> model = node.getBricks();
    if (!model || model->getBricks().empty())
    {
        error = "has no bricks";
        return;
    }
    const GltfBricks bricks(*model, MOST_MATERIALS);
    if (bricks.hasColorsOfInstances())
        _warnings.push_back("its " + countOf(bricks.getNumColors(), "colour") +
                            " are attributes of instances, which some programs show as white; expected at most " +
                            std::to_string(MOST_MATERIALS) + ", as with a palette");
    _primitives.clear();
    _meshNumbers.clear();
    std::vector<JsonValue>& nodes = _models[&node];
    for (const auto& [key, instances] : bricks.getGroups())
        if (error.empty())
            nodes.push_back(createNode(model->getGrid(), key, bricks.hasColorsOfInstances(), instances, error));
}

JsonValue GltfWriter::createNode(const BrickGrid& grid, const GltfBricks::Key& key, bool hasColors,
                                 const std::vector<GltfBricks::Instance>& instances, std::string& error)
{
    const int up = grid.getUpIndex();
    const int first = (up + 1) % 3;
    const int second = (up + 2) % 3;
    std::vector<osg::Vec3> places;
    std::vector<osg::Vec3> colors;
    for (const GltfBricks::Instance& instance : instances)
    {
        const glm::dvec3 place = grid.cellSize * instance.place;
        glm::dvec3 local = place;
        if (key.isTurned) local[first] = place[second];
        if (key.isTurned) local[second] = -place[first];
        places.push_back(toOsg(local));
        if (hasColors) colors.push_back(toOsg(toLinear(instance.color)));
    }
    JsonValue attributes{{"TRANSLATION", _buffer.add(places, GltfBuffer::Use::INSTANCES)}};
    if (hasColors) attributes["_COLOR_0"] = _buffer.add(colors, GltfBuffer::Use::INSTANCES);

    JsonValue node{{"name", nameOf(key.shape, grid)},
                   {"mesh", addMesh(key.shape, hasColors ? Color{255, 255, 255} : key.color, grid, error)},
                   {"translation", toArray(grid.origin + grid.cellSize * GltfBricks::getCenter(key.block))}};
    if (key.isTurned)
    {
        const double half = 0.5 * std::numbers::sqrt2; // sine and cosine of half the right angle
        std::vector<JsonValue> rotation{0.0, 0.0, 0.0, half};
        rotation[static_cast<std::size_t>(up)] = half;
        node["rotation"] = JsonValue::createArray(std::move(rotation));
    }
    node["extensions"][INSTANCING]["attributes"] = attributes;
    return node;
}

JsonValue GltfWriter::addPrimitive(const GltfBricks::Shape& shape, const BrickGrid& grid, std::string& error)
{
    const auto known = _primitives.find(shape);
    if (known != _primitives.end()) return known->second;
    const GltfPartMesh mesh = GltfPartMesh::create(shape, grid);
    if (mesh.vertices.empty())
    {
        error = "has a part of " + nameOf(shape, grid) + "; expected parts of at most 8 x 8 cells";
        return {};
    }
    osg::BoundingBox bounds;
    for (const osg::Vec3& vertex : mesh.vertices)
        bounds.expandBy(vertex);
    const std::int64_t positions = _buffer.add(mesh.vertices, GltfBuffer::Use::VERTICES);
    _buffer.setBounds(positions, bounds._min, bounds._max);
    JsonValue primitive{
        {"attributes", {{"POSITION", positions}, {"NORMAL", _buffer.add(mesh.normals, GltfBuffer::Use::VERTICES)}}},
        {"indices", _buffer.add(mesh.indices)}};
    return _primitives[shape] = primitive;
}

std::int64_t GltfWriter::addMesh(const GltfBricks::Shape& shape, const Color& color, const BrickGrid& grid,
                                 std::string& error)
{
    const auto [place, isNew] = _meshNumbers.try_emplace({shape, color}, static_cast<std::int64_t>(_meshes.size()));
    if (!isNew) return place->second;
    JsonValue primitive = addPrimitive(shape, grid, error);
    primitive["material"] = addMaterial(color);
    JsonValue mesh{{"name", nameOf(shape, grid) + ", " + nameOf(color)}};
    mesh["primitives"].append(primitive);
    _meshes.push_back(mesh);
    return place->second;
}

std::int64_t GltfWriter::addMaterial(const Color& color)
{
    const auto [place, isNew] = _materialNumbers.try_emplace(color, static_cast<std::int64_t>(_materials.size()));
    if (!isNew) return place->second;
    JsonValue base = toArray(toLinear(color));
    base.append(1.0);
    _materials.push_back({{"name", nameOf(color)},
                          {"pbrMetallicRoughness",
                           {{"baseColorFactor", base}, {"metallicFactor", 0.0}, {"roughnessFactor", ROUGHNESS}}}});
    return place->second;
}

std::int64_t GltfWriter::addNode(JsonValue node)
{
    _nodes.push_back(std::move(node));
    return static_cast<std::int64_t>(_nodes.size()) - 1;
}

JsonValue GltfWriter::toJson() const
{
    JsonValue nodes = JsonValue::createArray(_nodes);
    const osg::Matrixd zToY(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
    nodes.append({{"name", "Z upwards"}, {"matrix", toArray(zToY)}, {"children", _placements}});
    const JsonValue extensions = JsonValue::createArray({INSTANCING});
    const JsonValue roots = JsonValue::createArray({_nodes.size()});
    return {{"asset", {{"version", "2.0"}, {"generator", "osgLego"}}},
            {"extensionsUsed", extensions},
            {"extensionsRequired", extensions},
            {"scene", 0},
            {"scenes", JsonValue::createArray({JsonValue{{"nodes", roots}}})},
            {"nodes", nodes},
            {"meshes", JsonValue::createArray(_meshes)},
            {"materials", JsonValue::createArray(_materials)},
            {"accessors", _buffer.getAccessors()},
            {"bufferViews", _buffer.getViews()},
            {"buffers", JsonValue::createArray({JsonValue{{"byteLength", _buffer.getBytes().size()}}})}};
}

std::string GltfWriter::write(std::ostream& stream) const
{
    std::string json = toJson().toString();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    constexpr std::size_t HEADERS = 12 + 8 + 8;
    const std::size_t size = HEADERS + json.size() + _buffer.getBytes().size();
    if (size > std::numeric_limits<std::uint32_t>::max())
        return "it would have " + formatNumber(size) + " bytes; expected at most 4,294,967,295, the limit of .glb";
    std::string header = "glTF";
    appendWord(header, 2);
    appendWord(header, size);
    stream << header << chunkHeader(json.size(), "JSON") << json << chunkHeader(_buffer.getBytes().size(), "BIN\0")
           << _buffer.getBytes();
    return stream ? std::string() : "it can't be written";
}

} // namespace osgLego
