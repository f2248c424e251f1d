#pragma once

#include <string>

namespace osgLego
{

/** Why a file can't be read, as far as can be checked beforehand: it does not exist, is a folder, or lacks permission.
 * Empty if nothing prevents it.
 *
 * May be called from any thread. */
std::string findObstacleToReading(const std::string& fileName);

} // namespace osgLego
