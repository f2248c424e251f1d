#pragma once

#include <functional>
#include <ostream>
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

/** Write a file atomically: beside it, renamed once it is complete. The new file has the permissions of the one that it
 * replaces; other hard links to that one keep the old content. Devices and pipes are written directly. Nothing is left
 * of an incomplete file, even if the process is killed, where the file system supports files without names.
 *
 * May be called from any thread.
 * @param write writes the content, in binary mode, and returns the reason if it fails for another reason than the
 * stream, or an empty text. It may throw.
 * @return the reason for a failure, after which an older file is unchanged; empty if the file is written. */
std::string writeCompleteFile(const std::string& fileName,
                              const std::function<std::string(std::ostream& stream)>& write);

} // namespace osgLego
