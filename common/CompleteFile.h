#pragma once

#include <functional>
#include <string>

namespace osgLego
{

/** Why a file can't be written, as far as can be checked beforehand; empty if nothing prevents it.
 *
 * May be called from any thread. */
std::string findObstacleToWriting(const std::string& fileName);

/** Whether two names refer to the same file, whether or not it exists, so that writing the second would overwrite the
 * first. Returns false for devices and pipes, which store nothing.
 *
 * May be called from any thread. */
bool isSameFile(const std::string& fileName, const std::string& otherName);

/** Write a file atomically: under a temporary name in the same folder, renamed once it is complete. Devices and pipes
 * are written directly.
 *
 * May be called from any thread.
 * @param write writes the file with the given temporary name, which has the same extension, and returns the reason if
 * it fails, or an empty text.
 * @return the reason for a failure, after which an older file is unchanged; empty if the file is written. */
std::string writeCompleteFile(const std::string& fileName,
                              const std::function<std::string(const std::string& temporaryName)>& write);

} // namespace osgLego
