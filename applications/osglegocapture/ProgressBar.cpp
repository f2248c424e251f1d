#include "ProgressBar.h"

#include "StandardError.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

constexpr const char* START_OF_EMPTY_LINE = "\r\x1b[K";

} // namespace

ProgressBar::ProgressBar() : _isTerminal(isatty(STDERR_FILENO) != 0), _printed(std::chrono::steady_clock::now()) {}

ProgressBar::~ProgressBar()
{
    clear();
}

void ProgressBar::setRange(double first, double last)
{
    _first = first;
    _last = last;
}

void ProgressBar::show(const std::string& work) const
{
    if (!_isTerminal) return printSometimes(work + " ...");
    printError("{}{} ...", START_OF_EMPTY_LINE, work);
    std::fflush(stderr);
}

void ProgressBar::show(double share, const std::string& work) const
{
    constexpr double WIDTH = 30.0;
    const double done = std::lerp(_first, _last, std::clamp(share, 0.0, 1.0));
    if (!_isTerminal) return printSometimes(fmt::format("{:.0f} %  {}", 100.0 * done, work));
    const auto filled = static_cast<std::size_t>(WIDTH * done);
    printError("{}[{:<{}}] {:3.0f} %  {}", START_OF_EMPTY_LINE, std::string(filled, '#'), static_cast<int>(WIDTH),
               100.0 * done, work);
    std::fflush(stderr);
}

void ProgressBar::clear() const
{
    if (!_isTerminal) return;
    printError("{}", START_OF_EMPTY_LINE);
    std::fflush(stderr);
}

void ProgressBar::warn(const std::string& warning) const
{
    if (warning.empty()) return;
    clear();
    printError("osglegocapture: warning: {}\n", warning);
}

void ProgressBar::printSometimes(const std::string& text) const
{
    constexpr std::chrono::seconds INTERVAL(30);
    const std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();
    if (now - _printed < INTERVAL) return;
    _printed = now;
    printError("osglegocapture: {}\n", text);
}

} // namespace osgLego
