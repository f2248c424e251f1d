#pragma once

#include <algorithm>

namespace osgLego
{

/** A channel of a colour, limited to 0 to 1; 0 for NaN, with which every comparison is false. */
template <typename Number>
Number toColorFraction(Number channel)
{
    return channel > Number(0) ? std::min(channel, Number(1)) : Number(0);
}

} // namespace osgLego
