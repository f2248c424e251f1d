#pragma once

#include <cstddef>
#include <optional>

namespace osgLego
{

/** Finds the highest resolution at which a model has at most a given number of parts.
 *
 * Usage:
 *
 *     ResolutionSearch search(500);
 *     while (const std::optional<unsigned int> resolution = search.getNext()) search.add(*resolution,
 * lay(*resolution)); search.getBest();
 *
 * The number of parts is expected to grow with the square of the resolution, more or less; where it does not grow, the
 * search ends at a resolution whose model has few enough parts while the next one tried has too many. One thread at a
 * time. */
class ResolutionSearch
{
public:
    /** @param mostParts at least 1. @param first the resolution to begin with, 1 to LegoSettings::MAXIMUM_RESOLUTION.
     */
    ResolutionSearch(std::size_t mostParts, unsigned int first) : _mostParts(mostParts), _next(first) {}

    /** The resolution to try next; nothing if the search has ended. */
    std::optional<unsigned int> getNext() const;
    /** Add the number of parts of the model at the resolution from getNext(). */
    void add(unsigned int resolution, std::size_t numParts);
    /** The highest resolution with few enough parts; 1 if none has. */
    unsigned int getBest() const { return _low == 0 ? 1 : _low; }

private:
    std::size_t _mostParts;
    unsigned int _next;
    unsigned int _low = 0;  // the highest resolution known to have few enough parts; 0: none
    unsigned int _high = 0; // the lowest above it that has too many; 0: none
};

} // namespace osgLego
