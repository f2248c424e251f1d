#include <osgLego/design/ResolutionSearch.h>

#include <osgLego/LegoSettings.h>

#include <algorithm>
#include <cmath>

namespace osgLego
{

std::optional<unsigned int> ResolutionSearch::getNext() const
{
    const unsigned int high = _high == 0 ? LegoSettings::MAXIMUM_RESOLUTION + 1 : _high;
    return _low + 1 < high ? std::optional(_next) : std::nullopt;
}

void ResolutionSearch::add(unsigned int resolution, std::size_t numParts)
{
    (numParts <= _mostParts ? _low : _high) = resolution;
    const unsigned int high = _high == 0 ? LegoSettings::MAXIMUM_RESOLUTION + 1 : _high;
    if (_low + 1 >= high) return;
    const double growth =
        std::sqrt(static_cast<double>(_mostParts) / static_cast<double>(std::max<std::size_t>(numParts, 1)));
    // A model of a few parts says little about larger ones.
    constexpr double MOST_GROWTH = 4.0;
    const double guess = std::floor(resolution * std::min(growth, MOST_GROWTH));
    _next = static_cast<unsigned int>(std::clamp(guess, _low + 1.0, high - 1.0));
}

} // namespace osgLego
