#pragma once

#include <istream>
#include <string>

/** Read the JSON text of a .gltf file, or of a .glb file, after which the stream is at the end of that text. */
std::string readGltfJson(std::istream& stream);
