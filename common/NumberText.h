#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace osgLego
{

/** A number with commas between groups of three digits. */
std::string formatNumber(std::size_t number);

/** A number with its noun, such as "1 part" or "1,200 parts". @param noun that forms its plural with an s. */
std::string countOf(std::size_t number, std::string_view noun);

} // namespace osgLego
