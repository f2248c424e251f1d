#pragma once

#include <cstddef>
#include <string>

namespace osgLego
{

/** A number with its noun, such as `1 part` or `2 parts`. */
inline std::string counted(std::size_t count, const std::string& singular, const std::string& plural)
{
    return std::to_string(count) + ' ' + (count == 1 ? singular : plural);
}

} // namespace osgLego
