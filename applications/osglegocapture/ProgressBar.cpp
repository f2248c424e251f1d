#include "ProgressBar.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

constexpr const char* START_OF_EMPTY_LINE = "\r\x1b[K";

} // namespace

ProgressBar::ProgressBar() : _isTerminal(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar()
{
    clear();
}

void ProgressBar::show(const std::string& work) const
{
    if (!_isTerminal) return;
    fmt::print(stderr, "{}{} ...", START_OF_EMPTY_LINE, work);
    std::fflush(stderr);
}

void ProgressBar::show(double share, const std::string& work) const
{
    constexpr double WIDTH = 30.0;
    if (!_isTerminal) return;
    const double done = std::clamp(share, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(WIDTH * done);
    fmt::print(stderr, "{}[{:<{}}] {:3.0f} %  {}", START_OF_EMPTY_LINE, std::string(filled, '#'),
               static_cast<int>(WIDTH), 100.0 * done, work);
    std::fflush(stderr);
}

void ProgressBar::clear() const
{
    if (!_isTerminal) return;
    fmt::print(stderr, "{}", START_OF_EMPTY_LINE);
    std::fflush(stderr);
}

} // namespace osgLego
