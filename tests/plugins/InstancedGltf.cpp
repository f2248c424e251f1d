#include "InstancedGltf.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

std::uint32_t readWord(const std::string& bytes, std::size_t place)
{
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + place, 4);
    return word;
}

osg::Matrixd localMatrix(const JsonValue& node)
{
    if (node.contains("matrix"))
    {
        osg::Matrixd matrix;
        for (std::size_t value = 0; value < 16; ++value)
            matrix.ptr()[value] = node["matrix"].getElements().at(value).toNumber(); // columns, as rows of OSG
        return matrix;
    }
    osg::Matrixd matrix;
    if (node.contains("rotation"))
    {
        const auto& rotation = node["rotation"].getElements();
        matrix.makeRotate(osg::Quat(rotation.at(0).toNumber(), rotation.at(1).toNumber(), rotation.at(2).toNumber(),
                                    rotation.at(3).toNumber()));
    }
    if (node.contains("translation"))
    {
        const auto& place = node["translation"].getElements();
        matrix.postMultTranslate(osg::Vec3d(place.at(0).toNumber(), place.at(1).toNumber(), place.at(2).toNumber()));
    }
    return matrix;
}

/** The transfer function of sRGB (IEC 61966-2-1). */
int encode(double linear)
{
    const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    EXPECT_NEAR(255.0 * value, std::round(255.0 * value), 0.001) << "a colour is no byte of sRGB";
    return static_cast<int>(std::lround(255.0 * value));
}

} // namespace

InstancedGltf::InstancedGltf(const std::string& bytes)
{
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(readWord(bytes, 4), 2u);
    EXPECT_EQ(readWord(bytes, 8), bytes.size());
    const std::size_t length = readWord(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    _json = JsonValue::parse(bytes.substr(20, length)).value();
    EXPECT_EQ(readWord(bytes, 20 + length), bytes.size() - 28 - length);
    EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
    _buffer = bytes.substr(28 + length);
    for (const JsonValue& root : _json["scenes"].getElements().at(0)["nodes"].getElements())
        visit(root.toInteger(), {});
}

std::size_t InstancedGltf::findData(const JsonValue& accessor) const
{
    const JsonValue& view = getAll("bufferViews").at(static_cast<std::size_t>(accessor["bufferView"].toInteger()));
    EXPECT_LE(view["byteOffset"].toInteger() + view["byteLength"].toInteger(),
              static_cast<std::int64_t>(_buffer.size()));
    return static_cast<std::size_t>(view["byteOffset"].toInteger());
}

std::vector<osg::Vec3> InstancedGltf::getVectors(const JsonValue& number) const
{
    const JsonValue& accessor = getAll("accessors").at(static_cast<std::size_t>(number.toInteger()));
    EXPECT_EQ(accessor["type"].toText(), "VEC3");
    EXPECT_EQ(accessor["componentType"].toInteger(), 5126);
    std::vector<osg::Vec3> vectors(static_cast<std::size_t>(accessor["count"].toInteger()));
    std::memcpy(vectors.data(), _buffer.data() + findData(accessor), vectors.size() * sizeof(osg::Vec3));
    return vectors;
}

std::vector<unsigned int> InstancedGltf::getIndices(const JsonValue& number) const
{
    const JsonValue& accessor = getAll("accessors").at(static_cast<std::size_t>(number.toInteger()));
    EXPECT_EQ(accessor["componentType"].toInteger(), 5123);
    std::vector<std::uint16_t> indices(static_cast<std::size_t>(accessor["count"].toInteger()));
    std::memcpy(indices.data(), _buffer.data() + findData(accessor), indices.size() * 2);
    return {indices.begin(), indices.end()};
}

void InstancedGltf::visit(std::int64_t number, const osg::Matrixd& parent)
{
    const JsonValue& node = getAll("nodes").at(static_cast<std::size_t>(number));
    const osg::Matrixd toWorld = localMatrix(node) * parent;
    if (node.contains("mesh")) addInstances(number, toWorld);
    if (!node.contains("children")) return;
    for (const JsonValue& child : node["children"].getElements())
        visit(child.toInteger(), toWorld);
}

void InstancedGltf::addInstances(std::int64_t number, const osg::Matrixd& toWorld)
{
    const JsonValue& node = getAll("nodes").at(static_cast<std::size_t>(number));
    const JsonValue& mesh = getAll("meshes").at(static_cast<std::size_t>(node["mesh"].toInteger()));
    const JsonValue& primitive = mesh["primitives"].getElements().at(0);
    const JsonValue& material = getAll("materials").at(static_cast<std::size_t>(primitive["material"].toInteger()));
    const auto& base = material["pbrMetallicRoughness"]["baseColorFactor"].getElements();
    const std::vector<osg::Vec3> vertices = getVectors(primitive["attributes"]["POSITION"]);
    const JsonValue& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    const std::vector<osg::Vec3> places = getVectors(attributes["TRANSLATION"]);
    std::vector<osg::Vec3> colors(places.size(), osg::Vec3(1, 1, 1));
    if (attributes.contains("_COLOR_0")) colors = getVectors(attributes["_COLOR_0"]);
    for (std::size_t instance = 0; instance < places.size(); ++instance)
    {
        Box box;
        box.node = number;
        for (const osg::Vec3& vertex : vertices)
        {
            const osg::Vec3d corner = osg::Vec3d(vertex + places[instance]) * toWorld;
            box.bounds.expandBy(corner.x(), -corner.z(), corner.y());
        }
        for (int channel = 0; channel < 3; ++channel)
            box.color[static_cast<std::size_t>(channel)] =
                encode(base.at(static_cast<std::size_t>(channel)).toNumber() * double{colors.at(instance)[channel]});
        _boxes.push_back(box);
    }
}

} // namespace osgLego::test
