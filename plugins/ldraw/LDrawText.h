#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace osgLego
{

/** The most bytes that are read of a file: more than the text of LDrawResolver::MOST_LINES parts usually takes. */
inline constexpr std::uintmax_t LARGEST_TEXT = std::uintmax_t(1) << 30;

/** The content of a file. @return nothing, with the reason in `error`, if it can't be read, is a device or a pipe,
 * which may have no end, or is larger than LARGEST_TEXT. */
std::optional<std::string> readText(const std::string& path, std::string& error);

/** The rest of a stream. @return nothing, with the reason in `error`, if it can't be read or has more than `largest`
 * bytes. */
std::optional<std::string> readText(std::istream& stream, std::string& error, std::uintmax_t largest = LARGEST_TEXT);

/** A text of a file as UTF-8: unchanged if it is, or else from Latin-1. */
std::string toUtf8(std::string_view text);

/** A text for one line, in which spaces replace control characters. */
std::string replaceControlCharacters(std::string_view text);

/** The name of a part's file, such as 3001.dat. @param number of LDraw. */
std::string toPartFile(std::string_view number);
/** The number of the part that a normalized name of a file has; empty if it is not that of a part. */
std::string_view toPartNumber(std::string_view file);

} // namespace osgLego
