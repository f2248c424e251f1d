#include "GltfDocument.h"

#include <cstdint>

namespace osgLego::test
{

namespace
{

void appendWord(std::string& bytes, std::size_t word)
{
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(word >> shift & 0xff);
}

void appendChunk(std::string& file, std::string bytes, const char* type, char padding)
{
    bytes.resize((bytes.size() + 3) / 4 * 4, padding);
    appendWord(file, bytes.size());
    file.append(type, 4);
    file += bytes;
}

} // namespace

int GltfDocument::add(const std::vector<osg::Vec3>& values)
{
    return addAccessor(values.data(), values.size(), sizeof(osg::Vec3),
                       R"("componentType":5126,"type":"VEC3","min":[-9,-9,-9],"max":[9,9,9])");
}

int GltfDocument::add(const std::vector<osg::Vec2>& values)
{
    return addAccessor(values.data(), values.size(), sizeof(osg::Vec2), R"("componentType":5126,"type":"VEC2")");
}

int GltfDocument::add(const std::vector<osg::Vec4>& values)
{
    return addAccessor(values.data(), values.size(), sizeof(osg::Vec4), R"("componentType":5126,"type":"VEC4")");
}

int GltfDocument::addIndices(const std::vector<unsigned short>& values)
{
    return addAccessor(values.data(), values.size(), 2, R"("componentType":5123,"type":"SCALAR")");
}

void GltfDocument::addPicture(const std::string& bytes)
{
    const int view = addView(bytes.data(), bytes.size());
    _image = R"({"mimeType":"image/png","bufferView":)" + std::to_string(view) + "}";
}

void GltfDocument::addPictureFile(const std::string& uri)
{
    _image = R"({"uri":")" + uri + "\"}";
}

void GltfDocument::addPrimitive(const std::string& attributes, const std::string& rest, int materialNumber)
{
    if (!_primitives.empty()) _primitives += ",";
    _primitives += R"({"material":)" + std::to_string(materialNumber) + R"(,"attributes":{)" + attributes + "}" +
                   (rest.empty() ? "" : "," + rest) + "}";
}

std::string GltfDocument::toText(const std::string& buffer) const
{
    const std::string uri = buffer.empty() ? "" : R"("uri":")" + buffer + "\",";
    std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes;
    text += R"(,"meshes":[{"primitives":[)" + _primitives + "]}]";
    text += R"(,"materials":[)" + material + "]";
    text += R"(,"buffers":[{)" + uri + R"("byteLength":)" + std::to_string(_buffer.size()) + "}]";
    text += R"(,"bufferViews":[)" + _views + R"(],"accessors":[)" + _accessors + "]";
    if (!_image.empty())
        text += R"(,"images":[)" + _image + R"(],"samplers":)" + samplers + R"(,"textures":[)" + texture + "]";
    return text + "}";
}

std::string GltfDocument::toBinary() const
{
    std::string chunks;
    appendChunk(chunks, toText({}), "JSON", ' ');
    appendChunk(chunks, _buffer, "BIN\0", '\0');
    std::string file = "glTF";
    appendWord(file, 2);
    appendWord(file, 12 + chunks.size());
    return file + chunks;
}

int GltfDocument::addView(const void* data, std::size_t size)
{
    _buffer.resize((_buffer.size() + 3) / 4 * 4);
    if (!_views.empty()) _views += ",";
    _views += R"({"buffer":0,"byteOffset":)" + std::to_string(_buffer.size()) + R"(,"byteLength":)" +
              std::to_string(size) + "}";
    _buffer.append(static_cast<const char*>(data), size);
    return _numViews++;
}

int GltfDocument::addAccessor(const void* data, std::size_t count, std::size_t size, const std::string& description)
{
    const int view = addView(data, count * size);
    if (!_accessors.empty()) _accessors += ",";
    _accessors +=
        R"({"bufferView":)" + std::to_string(view) + R"(,"count":)" + std::to_string(count) + "," + description + "}";
    return _numAccessors++;
}

} // namespace osgLego::test
