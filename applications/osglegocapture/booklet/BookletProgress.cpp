#include "BookletProgress.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace osgLego
{

BookletProgress::BookletProgress() : _isTerminal(isatty(STDERR_FILENO) != 0) {}

BookletProgress::~BookletProgress()
{
    if (_isTerminal) fmt::print(stderr, "\r\x1b[K");
}

void BookletProgress::show(double share, const std::string& work)
{
    constexpr double WIDTH = 30.0;
    if (!_isTerminal) return;
    const double done = std::clamp(share, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(WIDTH * done);
    fmt::print(stderr, "\r\x1b[K[{:<{}}] {:3.0f} %  {}", std::string(filled, '#'), static_cast<int>(WIDTH),
               100.0 * done, work);
    std::fflush(stderr);
}

} // namespace osgLego
