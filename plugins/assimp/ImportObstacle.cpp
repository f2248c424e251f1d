#include "ImportObstacle.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string_view>

namespace
{

/** The JSON text of a file. */
std::string readJson(std::istream& stream)
{
    std::array<char, 20> header{}; // of .glb: magic, version, length, length of the JSON text, type
    stream.read(header.data(), header.size());
    std::string text(header.data(), static_cast<std::size_t>(stream.gcount()));
    if (!text.starts_with("glTF"))
        return text.append(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    std::uint32_t length = 0;
    for (std::size_t byte = 4; byte-- > 0;)
        length = length << 8 | static_cast<unsigned char>(header[12 + byte]);
    text.clear();
    std::array<char, 4096> block{};
    while (length > 0 && stream)
    {
        stream.read(block.data(), std::min<std::streamsize>(length, block.size()));
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        length -= static_cast<std::uint32_t>(stream.gcount());
    }
    return text;
}

std::string findRequiredExtension(const std::string& json)
{
    const std::size_t begin = json.find("\"extensionsRequired\"");
    if (begin == std::string::npos) return {};
    const std::string list = json.substr(begin, json.find(']', begin) - begin);
    for (const char* extension : {"EXT_mesh_gpu_instancing", "EXT_meshopt_compression"})
        if (list.find(extension) != std::string::npos)
            return std::string("it requires the extension ") + extension +
                   ", which Assimp does not support; expected a file without it";
    return {};
}

std::string findWrongMimeType(const std::string& json)
{
    constexpr std::string_view KEY = "\"mimeType\"";
    for (std::size_t key = json.find(KEY); key != std::string::npos; key = json.find(KEY, key + 1))
    {
        const std::size_t begin = json.find('"', key + KEY.size());
        const std::size_t end = begin == std::string::npos ? begin : json.find('"', begin + 1);
        if (end == std::string::npos) continue; // no JSON, as Assimp notices
        const std::string type = json.substr(begin + 1, end - begin - 1);
        if (type.find('/') == std::string::npos)
            return "'" + type + "' is not a MIME type; expected one such as image/png";
    }
    return {};
}

std::string findGltfObstacle(std::istream& stream)
{
    const std::string json = readJson(stream);
    const std::string extension = findRequiredExtension(json);
    return extension.empty() ? findWrongMimeType(json) : extension;
}

/** The next word of a text in which comments begin with #. */
std::string readWord(std::istream& stream)
{
    std::string word;
    std::string comment;
    while (stream >> word && word.front() == '#')
        std::getline(stream, comment);
    return stream ? word : std::string();
}

std::string findOffObstacle(std::istream& stream)
{
    readWord(stream); // OFF
    const std::uint64_t vertices = std::strtoull(readWord(stream).c_str(), nullptr, 10);
    const std::uint64_t faces = std::strtoull(readWord(stream).c_str(), nullptr, 10);
    stream.clear();
    stream.seekg(0, std::ios::end);
    const std::streamoff size = stream.tellg();
    if (size >= 0 && std::max(vertices, faces) <= static_cast<std::uint64_t>(size)) return {};
    return "it claims to have " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
           " faces; expected at most as many as its " + std::to_string(size) + " characters";
}

} // namespace

std::string findImportObstacle(const std::string& format, std::istream& stream)
{
    if (format == "glb" || format == "gltf") return findGltfObstacle(stream);
    return format == "off" ? findOffObstacle(stream) : std::string();
}
