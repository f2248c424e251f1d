#pragma once

#include "BenchMeshes.h"

#include <optional>
#include <string>

namespace osgLego
{

/** By how many megabytes this process's peak of resident memory grows while a contender prepares and runs, twice.
 *
 * What GL and the contender need whatever the grid is like, as compiled shaders, is there before, from a run at a
 * resolution of 8. On a GPU of its own memory, that is not counted. Throws std::runtime_error. */
double measureFootprint(const MeshSource& source, unsigned int resolution, const std::string& contender);

/** The same in a process of its own, which no one has used memory in before; nothing when the contender can't. */
std::optional<double> measureFootprintApart(const MeshSource& source, unsigned int resolution,
                                            const std::string& contender);

} // namespace osgLego
