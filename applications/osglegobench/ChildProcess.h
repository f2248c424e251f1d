#pragma once

#include <optional>
#include <string>
#include <vector>

namespace osgLego
{

/** Run this program once more, as a process of its own.
 * @return all that it writes to its standard output; nothing when it fails. Throws std::runtime_error. */
std::optional<std::string> runThisProgram(std::vector<std::string> arguments);

} // namespace osgLego
