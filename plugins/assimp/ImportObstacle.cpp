#include "ImportObstacle.h"

#include "GltfJson.h"
#include "Nesting.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string_view>

namespace
{

std::string findRequiredExtension(const std::string& format, const std::string& json)
{
    const std::size_t begin = json.find("\"extensionsRequired\"");
    if (begin == std::string::npos) return {};
    const std::string list = json.substr(begin, json.find(']', begin) - begin);
    if (list.find("EXT_meshopt_compression") != std::string::npos)
        return "it requires the extension EXT_meshopt_compression, which Assimp ignores; expected a file without it";
    if (format != "glb" && list.find("EXT_mesh_gpu_instancing") != std::string::npos)
        return "it requires the extension EXT_mesh_gpu_instancing; expected it in a .glb file only";
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

std::string findGltfObstacle(const std::string& format, std::istream& stream)
{
    const std::string json = readGltfJson(stream);
    if (std::string nesting = findNestingObstacle(format, json); !nesting.empty()) return nesting;
    const std::string extension = findRequiredExtension(format, json);
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
    if (format == "glb" || format == "gltf") return findGltfObstacle(format, stream);
    if (format == "off") return findOffObstacle(stream);
    for (const char* nested : {"b3d", "fbx", "x3d", "xgl"})
        if (format == nested)
            return findNestingObstacle(format, std::string(std::istreambuf_iterator<char>(stream), {}));
    return {};
}
