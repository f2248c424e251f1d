#pragma once

#include <functional>
#include <string>

namespace osgLego
{

/** Why a file can't be written where it should be, as far as that shows beforehand; empty when nothing is in the way.
 *
 * May be called from any thread. */
std::string findObstacleToWriting(const std::string& fileName);

/** Whether two names are of one file, be it there or not, so that writing both would lose the first. Devices and pipes,
 * which keep nothing, are never one.
 *
 * May be called from any thread. */
bool isSameFile(const std::string& fileName, const std::string& otherName);

/** Write a file so that it is there complete or not at all: under another name beside its own, got in the end. What
 * is no file but a device or a pipe is written as it is.
 *
 * May be called from any thread.
 * @param write makes the file of the name that it is given, which has the same extension, and answers why it can't; an
 * empty text if it can.
 * @return why there is no file now, or still the one of before; empty when it is written. */
std::string writeCompleteFile(const std::string& fileName,
                              const std::function<std::string(const std::string& temporaryName)>& write);

} // namespace osgLego
