#pragma once

#include "BenchMeshes.h"

#include <common/JsonValue.h>

#include <string>

namespace osgLego
{

/** The milliseconds between the cancellation of a legolization and its end, for cancellations at times that are spread
 * evenly over it. Throws std::runtime_error if the mesh can't be read or the settings are wrong.
 * @param settings as in `.legolize`.
 * @param mostSeconds cancellations come at most that long after the beginning. */
JsonValue measureCancellation(const MeshSource& mesh, const std::string& settings, unsigned int numRuns,
                              double mostSeconds);

} // namespace osgLego
