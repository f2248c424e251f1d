#pragma once

#include <string>

namespace osgLego
{

/** Throws std::runtime_error when a file can't be written where it should be; for asking before hours of measuring.
 * @param fileName empty: nothing is to be written. */
void checkPlace(const std::string& fileName);

/** Write a text, completely or not at all. Throws std::runtime_error. */
void writeTextFile(const std::string& fileName, const std::string& text);

} // namespace osgLego
