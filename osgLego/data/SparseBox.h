#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A value for each place of a box; `Value()` where none was set.
 *
 * The box is divided into pages of 16 x 16 x 16 places, and only pages in which a value was set are in memory, so that
 * it follows the number of values. Each page, with or without memory, takes 4 bytes more: 2.5 MiB for the cells of the
 * largest grid (GridLimits).
 *
 * One thread may change it, or several may read it. */
template <typename Value>
class SparseBox
{
public:
    SparseBox() = default;
    /** @param size the number of places along each axis. */
    explicit SparseBox(const glm::ivec3& size) : _numPages((size + SIDE - 1) / SIDE)
    {
        _pageNumbers.resize(indexIn(_numPages, {0, 0, _numPages.z}));
    }

    /** @param place from 0 to the size, exclusive. */
    const Value& get(const glm::ivec3& place) const
    {
        return _pages[_pageNumbers[indexIn(_numPages, getPage(place))]][indexIn(glm::ivec3(SIDE), getPlaceIn(place))];
    }

    /** The value of a place, to be changed. @param place from 0 to the size, exclusive. */
    Value& edit(const glm::ivec3& place)
    {
        std::uint32_t& number = _pageNumbers[indexIn(_numPages, getPage(place))];
        if (number == EMPTY)
        {
            _pages.emplace_back();
            number = static_cast<std::uint32_t>(_pages.size() - 1);
        }
        return _pages[number][indexIn(glm::ivec3(SIDE), getPlaceIn(place))];
    }

    /** The number of pages in memory. */
    std::size_t getNumPages() const { return _pages.size() - 1; }

private:
    static constexpr int SHIFT = 4;
    static constexpr int SIDE = 1 << SHIFT;
    static constexpr std::uint32_t EMPTY = 0; // the page that all places without values share
    using Page = std::array<Value, SIDE * SIDE * SIDE>;

    // Not by division, since compilers don't know that no place is negative.
    static glm::ivec3 getPage(const glm::ivec3& place) { return place >> SHIFT; }
    static glm::ivec3 getPlaceIn(const glm::ivec3& place) { return place & (SIDE - 1); }

    static std::size_t indexIn(const glm::ivec3& size, const glm::ivec3& place)
    {
        return static_cast<std::size_t>(place.x) +
               static_cast<std::size_t>(size.x) *
                   (static_cast<std::size_t>(place.y) +
                    static_cast<std::size_t>(size.y) * static_cast<std::size_t>(place.z));
    }

    glm::ivec3 _numPages{0};                         // along each axis
    std::vector<std::uint32_t> _pageNumbers;         // of all pages of the box
    std::vector<Page> _pages = std::vector<Page>(1); // the first is EMPTY
};

} // namespace osgLego
