#pragma once

#include <common/JsonValue.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <osg/Vec3>

namespace osgLego
{

/** The binary data of a glTF file, with its buffer views and accessors. One thread. */
class GltfBuffer
{
public:
    /** What an array is for: the values of bufferView.target in glTF. */
    enum class Use
    {
        INSTANCES = 0,
        VERTICES = 34962, // ARRAY_BUFFER
        INDICES = 34963   // ELEMENT_ARRAY_BUFFER
    };

    /** Add an array. @param use VERTICES or INSTANCES. @return the number of its accessor. */
    std::int64_t add(std::span<const osg::Vec3> vectors, Use use);
    /** Add the indices of triangles, each below 65535. @return the number of their accessor. */
    std::int64_t add(std::span<const std::uint16_t> indices);
    /** Declare the bounds of an array, which glTF requires for positions. */
    void setBounds(std::int64_t accessor, const osg::Vec3& lowest, const osg::Vec3& highest);

    const std::string& getBytes() const { return _bytes; }
    JsonValue getViews() const { return JsonValue::createArray(_views); }
    JsonValue getAccessors() const { return JsonValue::createArray(_accessors); }

private:
    std::int64_t addArray(std::span<const std::byte> bytes, std::size_t count, Use use, JsonValue accessor);

    std::string _bytes;
    std::vector<JsonValue> _views;
    std::vector<JsonValue> _accessors;
};

} // namespace osgLego
