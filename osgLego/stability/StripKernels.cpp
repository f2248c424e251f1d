#include <osgLego/stability/StripKernels.h>

#include <cmath>
#include <cstring>

// Loops over registers have to be unrolled, so that their elements stay in registers.
#if defined(__clang__)
#define OSGLEGO_UNROLL _Pragma("unroll")
#define OSGLEGO_INLINE inline __attribute__((always_inline))
#elif defined(__GNUC__)
#define OSGLEGO_UNROLL _Pragma("GCC unroll 24")
#define OSGLEGO_INLINE inline __attribute__((always_inline))
#else
#error "expected GCC or Clang, whose vectors the kernels use"
#endif

namespace osgLego
{

namespace
{

constexpr std::size_t ROWS = StripKernels::NUM_ROWS;
// Replaces the root of a pivot of 0, so that the solution is 0 there.
constexpr double INFINITE_ROOT = 1e50;

/** Registers of 2, 4 or 8 numbers. Compilers ignore attributes of types that depend on a parameter of a template. */
struct Register2
{
    using Vector = double __attribute__((vector_size(16)));
};
struct Register4
{
    using Vector = double __attribute__((vector_size(32)));
};
struct Register8
{
    using Vector = double __attribute__((vector_size(64)));
};

/** The kernels for one size of registers. @tparam COLUMNS and NUM_VECTORS the registers that sums of a product take. */
template <class Register, std::size_t NUM_VECTORS, std::size_t COLUMNS>
struct Kernels
{
    using Vector = typename Register::Vector;
    static constexpr std::size_t LENGTH = sizeof(Vector) / sizeof(double);
    static constexpr std::size_t PART = NUM_VECTORS * LENGTH; //!< rows
    static_assert(ROWS % PART == 0 && ROWS % COLUMNS == 0);

    /** Not by value, which functions for different processors pass differently. */
    static OSGLEGO_INLINE void load(const double* place, Vector& vector)
    {
        std::memcpy(&vector, place, sizeof(Vector));
    }
    static OSGLEGO_INLINE void store(const Vector& vector, double* place)
    {
        std::memcpy(place, &vector, sizeof(Vector));
    }

    static OSGLEGO_INLINE void subtractPart(const double* left, const double* right, std::size_t numColumns,
                                            double* result)
    {
        Vector sums[COLUMNS][NUM_VECTORS];
        OSGLEGO_UNROLL for (std::size_t column = 0; column < COLUMNS; ++column)
            OSGLEGO_UNROLL for (std::size_t part = 0; part < NUM_VECTORS; ++part) sums[column][part] = Vector{};
        for (std::size_t k = 0; k < numColumns; ++k, left += ROWS, right += ROWS)
        {
            Vector parts[NUM_VECTORS];
            OSGLEGO_UNROLL for (std::size_t part = 0; part < NUM_VECTORS; ++part)
                load(left + part * LENGTH, parts[part]);
            OSGLEGO_UNROLL for (std::size_t column = 0; column < COLUMNS; ++column)
                OSGLEGO_UNROLL for (std::size_t part = 0; part < NUM_VECTORS; ++part) sums[column][part] +=
                parts[part] * right[column];
        }
        OSGLEGO_UNROLL for (std::size_t column = 0; column < COLUMNS; ++column)
            OSGLEGO_UNROLL for (std::size_t part = 0; part < NUM_VECTORS; ++part)
        {
            Vector value;
            load(result + column * ROWS + part * LENGTH, value);
            value -= sums[column][part];
            store(value, result + column * ROWS + part * LENGTH);
        }
    }

    static OSGLEGO_INLINE void subtractProduct(const double* left, const double* right, std::size_t numColumns,
                                               double* result)
    {
        if (numColumns == 0) return; // the strips may be null
        for (std::size_t column = 0; column < ROWS; column += COLUMNS)
            for (std::size_t row = 0; row < ROWS; row += PART)
                subtractPart(left + row, right + column, numColumns, result + column * ROWS + row);
    }

    /** Subtract the products with previous columns from a column. */
    static OSGLEGO_INLINE void subtractPrevious(const double* triangle, std::size_t column, double* strip)
    {
        constexpr std::size_t COUNT = ROWS / LENGTH;
        Vector rest[COUNT];
        OSGLEGO_UNROLL for (std::size_t part = 0; part < COUNT; ++part)
            load(strip + column * ROWS + part * LENGTH, rest[part]);
        for (std::size_t k = 0; k < column; ++k)
            OSGLEGO_UNROLL for (std::size_t part = 0; part < COUNT; ++part)
            {
                Vector value;
                load(strip + k * ROWS + part * LENGTH, value);
                rest[part] -= value * triangle[k * ROWS + column];
            }
        OSGLEGO_UNROLL for (std::size_t part = 0; part < COUNT; ++part)
            store(rest[part], strip + column * ROWS + part * LENGTH);
    }

    static OSGLEGO_INLINE void factorize(double* strip, std::size_t numColumns, const double* leastPivots,
                                         double* reciprocals)
    {
        for (std::size_t column = 0; column < numColumns; ++column)
        {
            double* values = strip + column * ROWS;
            subtractPrevious(strip, column, strip);
            const double pivot = values[column] > leastPivots[column] ? values[column] : leastPivots[column];
            const double root = pivot > 0.0 ? std::sqrt(pivot) : INFINITE_ROOT;
            reciprocals[column] = 1.0 / root;
            for (std::size_t row = 0; row < column; ++row)
                values[row] = 0.0;
            values[column] = root;
            for (std::size_t row = column + 1; row < ROWS; ++row)
                values[row] *= reciprocals[column];
        }
    }

    static OSGLEGO_INLINE void divide(const double* triangle, const double* reciprocals, std::size_t numColumns,
                                      double* strip)
    {
        for (std::size_t column = 0; column < numColumns; ++column)
        {
            subtractPrevious(triangle, column, strip);
            for (std::size_t row = 0; row < ROWS; ++row)
                strip[column * ROWS + row] *= reciprocals[column];
        }
    }

    static OSGLEGO_INLINE void subtractVector(const double* strip, std::size_t numColumns, const double* vector,
                                              double* result)
    {
        constexpr std::size_t COUNT = ROWS / LENGTH;
        Vector rest[COUNT];
        OSGLEGO_UNROLL for (std::size_t part = 0; part < COUNT; ++part) load(result + part * LENGTH, rest[part]);
        for (std::size_t k = 0; k < numColumns; ++k, strip += ROWS)
            OSGLEGO_UNROLL for (std::size_t part = 0; part < COUNT; ++part)
            {
                Vector value;
                load(strip + part * LENGTH, value);
                rest[part] -= value * vector[k];
            }
        OSGLEGO_UNROLL for (std::size_t part = 0; part < COUNT; ++part) store(rest[part], result + part * LENGTH);
    }

    static OSGLEGO_INLINE void subtractTransposed(const double* strip, std::size_t numColumns, const double* vector,
                                                  double* result)
    {
        constexpr std::size_t COUNT = ROWS / LENGTH;
        Vector factors[COUNT];
        OSGLEGO_UNROLL for (std::size_t part = 0; part < COUNT; ++part) load(vector + part * LENGTH, factors[part]);
        for (std::size_t k = 0; k < numColumns; ++k, strip += ROWS)
        {
            Vector sum = Vector{};
            OSGLEGO_UNROLL for (std::size_t part = 0; part < COUNT; ++part)
            {
                Vector value;
                load(strip + part * LENGTH, value);
                sum += value * factors[part];
            }
            double total = 0.0;
            OSGLEGO_UNROLL for (std::size_t element = 0; element < LENGTH; ++element) total += sum[element];
            result[k] -= total;
        }
    }
};

#define OSGLEGO_KERNELS(NAME, TARGET, ...)                                                                             \
    struct NAME                                                                                                        \
    {                                                                                                                  \
        TARGET static void subtractProduct(const double* left, const double* right, std::size_t count, double* result) \
        {                                                                                                              \
            Kernels<__VA_ARGS__>::subtractProduct(left, right, count, result);                                         \
        }                                                                                                              \
        TARGET static void factorize(double* strip, std::size_t count, const double* leastPivots, double* reciprocals) \
        {                                                                                                              \
            Kernels<__VA_ARGS__>::factorize(strip, count, leastPivots, reciprocals);                                   \
        }                                                                                                              \
        TARGET static void divide(const double* triangle, const double* reciprocals, std::size_t count, double* strip) \
        {                                                                                                              \
            Kernels<__VA_ARGS__>::divide(triangle, reciprocals, count, strip);                                         \
        }                                                                                                              \
        TARGET static void subtractVector(const double* strip, std::size_t count, const double* vector,                \
                                          double* result)                                                              \
        {                                                                                                              \
            Kernels<__VA_ARGS__>::subtractVector(strip, count, vector, result);                                        \
        }                                                                                                              \
        TARGET static void subtractTransposed(const double* strip, std::size_t count, const double* vector,            \
                                              double* result)                                                          \
        {                                                                                                              \
            Kernels<__VA_ARGS__>::subtractTransposed(strip, count, vector, result);                                    \
        }                                                                                                              \
        static constexpr StripKernels ALL{subtractProduct, factorize, divide, subtractVector, subtractTransposed};     \
    };

OSGLEGO_KERNELS(PlainKernels, , Register2, 2, 4)
#if defined(__x86_64__)
OSGLEGO_KERNELS(Avx2Kernels, __attribute__((target("avx2,fma"))), Register4, 3, 4)
OSGLEGO_KERNELS(Avx512Kernels, __attribute__((target("avx512f"))), Register8, 3, 8)
#endif

#undef OSGLEGO_KERNELS

} // namespace

std::vector<StripKernels> StripKernels::getAll()
{
    std::vector<StripKernels> all;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) all.push_back(Avx512Kernels::ALL);
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) all.push_back(Avx2Kernels::ALL);
#endif
    all.push_back(PlainKernels::ALL);
    return all;
}

const StripKernels& StripKernels::get()
{
    static const StripKernels best = getAll().front();
    return best;
}

} // namespace osgLego
