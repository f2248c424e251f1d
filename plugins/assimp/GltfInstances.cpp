#include "GltfInstances.h"

#include "GltfJson.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <stdexcept>

#include <osg/Quat>

using osgLego::JsonValue;

namespace
{

constexpr const char* EXTENSION = "EXT_mesh_gpu_instancing";
constexpr std::size_t CHUNK_HEADER = 8;

const JsonValue& elementOf(const JsonValue& array, const JsonValue& number)
{
    return array.getElements().at(static_cast<std::size_t>(number.toInteger()));
}

std::size_t sizeOf(const JsonValue& object, const char* name)
{
    const std::int64_t size = object.contains(name) ? object[name].toInteger() : 0;
    if (size < 0) throw std::out_of_range(name);
    return static_cast<std::size_t>(size);
}

} // namespace

std::string GltfInstances::read(std::istream& stream)
try
{
    const std::string text = readGltfJson(stream);
    if (text.find(EXTENSION) == std::string::npos) return {};
    stream.ignore(CHUNK_HEADER);
    _buffer.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    _json = JsonValue::parse(text).value_or(JsonValue());
    const JsonValue& json = _json;
    const JsonValue& scene = elementOf(json["scenes"], json.contains("scene") ? json["scene"] : JsonValue(0));
    const std::vector<JsonValue>& roots = scene["nodes"].getElements();
    _hasOneRoot = roots.size() == 1;
    for (const JsonValue& root : roots)
        visit(root);
    return {};
}
catch (const std::logic_error&)
{
    return std::string("its instances of ") + EXTENSION + " can't be read; expected arrays of single precision";
}

const std::vector<osg::Matrixd>* GltfInstances::find(std::size_t number) const
{
    const auto found = _instances.find(number);
    return found == _instances.end() ? nullptr : &found->second;
}

void GltfInstances::visit(const JsonValue& number)
{
    const JsonValue& json = _json;
    const JsonValue& node = elementOf(json["nodes"], number);
    if (node.contains("extensions") && node["extensions"].contains(EXTENSION))
        _instances[_numNodes] = createTransforms(node["extensions"][EXTENSION]["attributes"]);
    ++_numNodes;
    if (!node.contains("children")) return;
    for (const JsonValue& child : node["children"].getElements())
        visit(child);
}

std::vector<osg::Matrixd> GltfInstances::createTransforms(const JsonValue& attributes) const
{
    const auto valuesOf = [&](const char* name, std::size_t channels)
    { return attributes.contains(name) ? readFloats(attributes[name], channels) : std::vector<float>(); };
    const std::vector<float> scales = valuesOf("SCALE", 3);
    const std::vector<float> turns = valuesOf("ROTATION", 4);
    const std::vector<float> places = valuesOf("TRANSLATION", 3);
    std::vector<osg::Matrixd> transforms(std::max({scales.size() / 3, turns.size() / 4, places.size() / 3}));
    for (std::size_t index = 0; index < transforms.size(); ++index)
    {
        if (3 * index < scales.size())
        {
            const float* scale = &scales[3 * index];
            transforms[index].makeScale(scale[0], scale[1], scale[2]);
        }
        if (4 * index < turns.size())
        {
            const float* turn = &turns[4 * index];
            transforms[index].postMultRotate({turn[0], turn[1], turn[2], turn[3]});
        }
        if (3 * index < places.size())
        {
            const float* place = &places[3 * index];
            transforms[index].postMultTranslate(osg::Vec3d(place[0], place[1], place[2]));
        }
    }
    return transforms;
}

std::vector<float> GltfInstances::readFloats(const JsonValue& number, std::size_t channels) const
{
    constexpr std::int64_t FLOAT = 5126;
    const JsonValue& json = _json;
    const JsonValue& accessor = elementOf(json["accessors"], number);
    const JsonValue& view = elementOf(json["bufferViews"], accessor["bufferView"]);
    const bool isPlain = accessor["componentType"].toInteger() == FLOAT && !view.contains("byteStride") &&
                         !accessor.contains("sparse") && view["buffer"].toInteger() == 0;
    const std::size_t begin = sizeOf(view, "byteOffset") + sizeOf(accessor, "byteOffset");
    const std::size_t count = sizeOf(accessor, "count");
    if (!isPlain || begin > _buffer.size() || count > (_buffer.size() - begin) / (channels * sizeof(float)))
        throw std::out_of_range("accessor");
    std::vector<float> values(channels * count);
    std::memcpy(values.data(), _buffer.data() + begin, values.size() * sizeof(float));
    return values;
}
