#pragma once

#include <istream>
#include <string>

/** The reason, in one sentence, why Assimp 5.2 would crash while reading a file, or take minutes; empty if none is
 * known: in .glb and .gltf a MIME type without a slash, in .off more vertices or faces than the file has characters.
 * @param format the extension in lower case. @param stream the content, from its beginning. */
std::string findImportObstacle(const std::string& format, std::istream& stream);
