#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace osgLego
{

/** Disjoint sets of numbers from 0 on. The lowest number of a set represents it. */
class UnionFind
{
public:
    /** Make `count` sets of one number each. */
    void reset(std::size_t count)
    {
        _parents.resize(count);
        std::iota(_parents.begin(), _parents.end(), std::int32_t(0));
    }
    std::size_t getCount() const { return _parents.size(); }
    /** Add a set of one number. */
    void add() { _parents.push_back(static_cast<std::int32_t>(_parents.size())); }

    std::int32_t find(std::int32_t number)
    {
        while (parent(number) != number)
            number = parent(number) = parent(parent(number));
        return number;
    }
    /** @return whether the numbers were in different sets. */
    bool join(std::int32_t a, std::int32_t b)
    {
        a = find(a);
        b = find(b);
        if (a == b) return false;
        (a < b ? parent(b) : parent(a)) = a < b ? a : b;
        return true;
    }

private:
    std::int32_t& parent(std::int32_t number) { return _parents[static_cast<std::size_t>(number)]; }

    std::vector<std::int32_t> _parents;
};

} // namespace osgLego
