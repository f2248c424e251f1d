#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/** The number of levels up to which elements of a file may be nested: Assimp, and visitors of scenes, call themselves
 * for each level, and crash when the stack of their thread is full. */
constexpr std::size_t MOST_LEVELS = 500;

/** The reason, in one sentence, why the elements of a file are nested too deeply, or why its nodes are no tree; empty
 * if there is none.
 * @param format the extension in lower case: glb, gltf, fbx, b3d, x3d or xgl.
 * @param content of the file; in .glb, its JSON text. */
std::string findNestingObstacle(const std::string& format, std::string_view content);
