#pragma once

#include "BenchMeshes.h"

#include <common/JsonValue.h>

#include <string>

namespace osgLego
{

/** The seconds that a legolization takes on one thread and on two, in turns. Throws std::runtime_error if the mesh
 * can't be read or the settings are wrong.
 * @param text settings as in `.legolize`.
 * @param numRuns of each number of threads. */
JsonValue measureScaling(const MeshSource& mesh, const std::string& text, unsigned int numRuns);

} // namespace osgLego
