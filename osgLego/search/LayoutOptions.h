#pragma once

#include <osgLego/LegoSettings.h>

#include <cstdint>
#include <functional>

namespace osgLego
{

/** How a layout is computed. */
struct LayoutOptions
{
    Effort effort = Effort::NORMAL;
    bool isGreedy = false; //!< whether parts are laid greedily and joined, without a search for better ones
    std::uint32_t seed = 0;
    int bond = 1; //!< a factor, 1 to 10, of the cost of stacked seams: parts overlap more if it is greater
    /** Called regularly, from any thread; the layout ends early if it returns true. May be empty. */
    std::function<bool()> isCancelled{};
    /** Called with the fraction done, 0 to 1, in one thread. May be empty. */
    std::function<void(double)> progress{};
};

} // namespace osgLego
