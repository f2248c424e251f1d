#pragma once

#include <string>
#include <string_view>

namespace osgLego
{

/** Replace the characters that have a meaning in XML and HTML, in text and in attributes with double quotes. */
std::string escapedForMarkup(std::string_view text);

} // namespace osgLego
