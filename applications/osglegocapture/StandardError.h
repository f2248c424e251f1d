#pragma once

#include <cstdio>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace osgLego
{

/** Print a text to standard error. It is lost if that can't be written: a log on a full disk must not end a run, which
 * the exception of fmt::print() would. */
template <typename... Arguments>
void printError(fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
    fmt::memory_buffer text; // on the stack, unless the text is long: messages on a lack of memory are short
    fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
    std::fwrite(text.data(), 1, text.size(), stderr);
}

} // namespace osgLego
