#pragma once

#include <cstdint>
#include <string>

namespace osgLego
{

/** The size in bytes of the file that a name begins with, which pseudo-loaders append to, such as
 * model.ply.64.legolize. 0 if there is none. */
std::uintmax_t findModelSize(std::string fileName);

/** Warn before a file is read that takes gigabytes of memory. */
void warnOfModelSize(const std::string& fileName);

} // namespace osgLego
