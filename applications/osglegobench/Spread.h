#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgLego
{

/** What measuring the same several times gave. */
struct Spread
{
    double minimum = 0.0;
    double lowerQuartile = 0.0;
    double median = 0.0;
    double upperQuartile = 0.0;
    double maximum = 0.0;

    /** @param values at least one. */
    static Spread create(std::vector<double> values)
    {
        std::sort(values.begin(), values.end());
        const auto at = [&values](double share)
        {
            const double place = share * static_cast<double>(values.size() - 1);
            const auto below = static_cast<std::size_t>(place);
            const std::size_t above = std::min(below + 1, values.size() - 1);
            return std::lerp(values[below], values[above], place - std::floor(place));
        };
        return {values.front(), at(0.25), at(0.5), at(0.75), values.back()};
    }
};

} // namespace osgLego
