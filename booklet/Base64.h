#pragma once

#include <string>
#include <string_view>

namespace osgLego
{

/** The Base64 encoding of bytes (RFC 4648), with padding and without line breaks. */
std::string toBase64(std::string_view bytes);

} // namespace osgLego
