#pragma once

#include <cstdio>
#include <utility>

#include <fmt/format.h>

namespace osgLego
{

/** Print a text to standard error. It is lost if that can't be written: a log on a full disk must not end a run, which
 * the exception of fmt::print() would. */
template <typename... Arguments>
void printError(fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
    std::fputs(fmt::format(format, std::forward<Arguments>(arguments)...).c_str(), stderr);
}

} // namespace osgLego
