#pragma once

#include "BenchMeshes.h"

#include <common/JsonValue.h>

#include <string>

namespace osgLego
{

/** The brick sets per second that frames show of a mesh that sways, and their rate beside that of the still mesh, in
 * turns. All vertices but the lowest move, by up to a tenth of the mesh's height. Throws std::runtime_error if the mesh
 * can't be read, if the settings are wrong, or without GL.
 * @param text settings as in `.legolize`; the lattice is that of the first state.
 * @param seconds of motion in each turn. */
JsonValue measureMotion(const MeshSource& mesh, const std::string& text, unsigned int numTurns, double seconds);

} // namespace osgLego
