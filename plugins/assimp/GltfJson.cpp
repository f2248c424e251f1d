#include "GltfJson.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

std::string readGltfJson(std::istream& stream)
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
