#pragma once

#include <common/JsonValue.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgLego
{

/** The interpolated quantile of sorted values.
 * @param values at least one. */
inline double getQuantile(const std::vector<double>& values, double share)
{
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - std::floor(place));
}

/** Median, extremes and quartiles of repeated measurements.
 * @param values at least one. */
inline JsonValue createSpread(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return {{"median", getQuantile(values, 0.5)},
            {"minimum", values.front()},
            {"lowerQuartile", getQuantile(values, 0.25)},
            {"upperQuartile", getQuantile(values, 0.75)},
            {"maximum", values.back()}};
}

} // namespace osgLego
