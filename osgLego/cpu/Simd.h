#pragma once

#include <array>
#include <cstddef>

// The only header that includes <experimental/simd>, which GCC's standard library provides. OSGLEGO_SCALAR, an option
// of CMake, chooses the scalar replacement, which is also used with other standard libraries.
#if !defined(OSGLEGO_SCALAR) && __has_include(<experimental/simd>)
#include <experimental/simd>
#define OSGLEGO_HAS_SIMD 1
#else
#define OSGLEGO_HAS_SIMD 0
#endif

namespace osgLego
{

#if OSGLEGO_HAS_SIMD

/** Several numbers of double precision on which every operation works at once. */
template <std::size_t COUNT>
using DoubleLanes = std::experimental::fixed_size_simd<double, COUNT>;

#else

template <std::size_t COUNT>
class DoubleLanes;

/** One truth value for each lane. */
template <std::size_t COUNT>
struct LaneMask
{
    std::array<bool, COUNT> lanes;

    friend LaneMask operator&&(const LaneMask& a, const LaneMask& b)
    {
        LaneMask result;
        for (std::size_t lane = 0; lane < COUNT; ++lane)
            result.lanes[lane] = a.lanes[lane] && b.lanes[lane];
        return result;
    }
};

/** Several numbers of double precision on which every operation works at once, lane by lane. */
template <std::size_t COUNT>
class DoubleLanes
{
public:
    using mask_type = LaneMask<COUNT>;

    DoubleLanes() = default;
    DoubleLanes(double value) { _lanes.fill(value); }
    /** @param generator returns the value of a lane. */
    template <typename Generator>
    requires requires(Generator generator) { generator(std::size_t{0}); }
    explicit DoubleLanes(Generator generator)
    {
        for (std::size_t lane = 0; lane < COUNT; ++lane)
            _lanes[lane] = generator(lane);
    }

    double operator[](std::size_t lane) const { return _lanes[lane]; }

    friend DoubleLanes operator+(const DoubleLanes& a, const DoubleLanes& b)
    {
        return combine(a, b, [](double x, double y) { return x + y; });
    }
    friend DoubleLanes operator-(const DoubleLanes& a, const DoubleLanes& b)
    {
        return combine(a, b, [](double x, double y) { return x - y; });
    }
    friend DoubleLanes operator*(const DoubleLanes& a, const DoubleLanes& b)
    {
        return combine(a, b, [](double x, double y) { return x * y; });
    }
    friend DoubleLanes min(const DoubleLanes& a, const DoubleLanes& b)
    {
        return combine(a, b, [](double x, double y) { return y < x ? y : x; });
    }
    friend DoubleLanes max(const DoubleLanes& a, const DoubleLanes& b)
    {
        return combine(a, b, [](double x, double y) { return x < y ? y : x; });
    }
    friend mask_type operator<(const DoubleLanes& a, const DoubleLanes& b)
    {
        mask_type mask;
        for (std::size_t lane = 0; lane < COUNT; ++lane)
            mask.lanes[lane] = a._lanes[lane] < b._lanes[lane];
        return mask;
    }
    friend mask_type operator>(const DoubleLanes& a, const DoubleLanes& b) { return b < a; }

    /** The lanes that a mask selects, to assign to. */
    class Selection
    {
    public:
        Selection(const mask_type& mask, DoubleLanes& target) : _mask(mask), _target(target) {}
        void operator=(const DoubleLanes& values) &&
        {
            for (std::size_t lane = 0; lane < COUNT; ++lane)
                if (_mask.lanes[lane]) _target._lanes[lane] = values._lanes[lane];
        }

    private:
        const mask_type& _mask;
        DoubleLanes& _target;
    };
    friend Selection where(const mask_type& mask, DoubleLanes& target) { return {mask, target}; }

private:
    template <typename Operation>
    static DoubleLanes combine(const DoubleLanes& a, const DoubleLanes& b, const Operation& operation)
    {
        DoubleLanes result;
        for (std::size_t lane = 0; lane < COUNT; ++lane)
            result._lanes[lane] = operation(a._lanes[lane], b._lanes[lane]);
        return result;
    }

    std::array<double, COUNT> _lanes{};
};

#endif

} // namespace osgLego
