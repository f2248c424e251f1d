#pragma once

#include <string>

namespace osgLego
{

/** A title for a model whose file has a name: "Stanford Bunny v2" for "models/stanford_bunny-v2.ply.64.legolize".
 *
 * Folders, extensions and pseudo-loaders with their settings are left out, `_` and `-` separate words, and words begin
 * with capitals, unless they are versions such as "v2". Capitals within words remain. Empty for an empty name. */
std::string toReadableName(const std::string& fileName);

} // namespace osgLego
