#include "GltfBuffer.h"

#include <utility>

namespace osgLego
{

namespace
{

// The types of components in glTF, which are those of GL.
constexpr int UNSIGNED_SHORT = 5123;
constexpr int FLOAT = 5126;

constexpr std::size_t ALIGNMENT = 4;

JsonValue toArray(const osg::Vec3& vector)
{
    JsonValue array = JsonValue::createArray();
    for (int axis = 0; axis < 3; ++axis)
        array.append(double{vector[axis]});
    return array;
}

} // namespace

std::int64_t GltfBuffer::add(std::span<const osg::Vec3> vectors, Use use)
{
    return addArray(std::as_bytes(vectors), vectors.size(), use, {{"componentType", FLOAT}, {"type", "VEC3"}});
}

std::int64_t GltfBuffer::add(std::span<const std::uint16_t> indices)
{
    return addArray(std::as_bytes(indices), indices.size(), Use::INDICES,
                    {{"componentType", UNSIGNED_SHORT}, {"type", "SCALAR"}});
}

void GltfBuffer::setBounds(std::int64_t accessor, const osg::Vec3& lowest, const osg::Vec3& highest)
{
    JsonValue& declared = _accessors[static_cast<std::size_t>(accessor)];
    declared["min"] = toArray(lowest);
    declared["max"] = toArray(highest);
}

std::int64_t GltfBuffer::addArray(std::span<const std::byte> bytes, std::size_t count, Use use, JsonValue accessor)
{
    JsonValue view{{"buffer", 0}, {"byteOffset", _bytes.size()}, {"byteLength", bytes.size()}};
    if (use != Use::INSTANCES) view["target"] = static_cast<int>(use);
    _bytes.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    _bytes.resize((_bytes.size() + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
    accessor["bufferView"] = _views.size();
    accessor["count"] = count;
    _views.push_back(std::move(view));
    _accessors.push_back(std::move(accessor));
    return static_cast<std::int64_t>(_accessors.size()) - 1;
}

} // namespace osgLego
