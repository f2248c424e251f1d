#pragma once

#include <string>

namespace osgLego
{

/** Why a file can't be read, as far as the file system tells before it is read: there is none, it is a folder, or it
 * may not be opened. Empty when it can.
 *
 * May be called from any thread. */
std::string findObstacleToReading(const std::string& fileName);

} // namespace osgLego
