#pragma once

#include <istream>
#include <string>

/** The reason, in one sentence, why a file can't be read, if Assimp 5.2 would not notice it, crash, or take minutes;
 * empty if none is known: in .glb and .gltf a required extension that Assimp ignores, or a MIME type without a slash;
 * in .off more vertices or faces than the file has characters; in formats with nested elements, see Nesting.h.
 * @param format the extension in lower case. @param stream the content, from its beginning. */
std::string findImportObstacle(const std::string& format, std::istream& stream);
