#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace osgLego
{

/** The lines of a text, one after the other, without spaces at their ends. A byte-order mark is ignored.
 *
 * Usage:
 *
 *     TextLines lines(text);
 *     while (lines.next())
 *         if (!read(lines.get())) return lines.expected("a colour", lines.get());
 */
class TextLines
{
public:
    /** @param text must outlive this object. */
    explicit TextLines(std::string_view text);

    /** Advance to the next line; the first call advances to the first line. @return false at the end. */
    bool next();
    std::string_view get() const { return _line; }

    /** One sentence that names this line, the `wanted` text and the text that was found there, which is shortened. */
    std::string expected(const std::string& wanted, std::string_view found) const;

private:
    std::string_view _rest;
    std::string_view _line;
    std::size_t _number = 0;
};

} // namespace osgLego
