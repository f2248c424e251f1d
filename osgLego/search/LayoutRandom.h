#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace osgLego
{

/** Random numbers that are the same on every machine: SplitMix64 (Steele, Lea and Flood 2014). */
class LayoutRandom
{
public:
    explicit LayoutRandom(std::uint64_t seed) : _state(seed) {}

    std::uint64_t next()
    {
        _state += 0x9e3779b97f4a7c15u;
        std::uint64_t bits = _state;
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
        return bits ^ (bits >> 31);
    }
    /** A number from 0 to count - 1. @param count 1 to 2^32. */
    std::size_t below(std::size_t count) { return static_cast<std::size_t>((next() >> 32) * count >> 32); }
    /** Put elements into a random order (Fisher and Yates). */
    template <typename Element>
    void shuffle(std::vector<Element>& elements)
    {
        for (std::size_t i = elements.size(); i > 1; --i)
            std::swap(elements[i - 1], elements[below(i)]);
    }

private:
    std::uint64_t _state;
};

} // namespace osgLego
