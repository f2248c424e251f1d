#include <osgLego/cpu/RowBundle.h>

#include <osgLego/data/WeightedColor.h>

#include <algorithm>
#include <bit>

#include <oneapi/tbb/parallel_for.h>

namespace osgLego
{

namespace
{

/** Reads the occupancy of all bundles of a grid, row by row. */
class RowOccupancy
{
public:
    RowOccupancy(const std::vector<RowBundle>& bundles, const glm::ivec3& dimensions) :
        _bundles(bundles), _dimensions(dimensions), _numBundles((dimensions.y + RowBundle::SIDE - 1) / RowBundle::SIDE),
        _numWords(RowBundle::numWords(dimensions.x)), _nothing(_numWords)
    {
    }

    const RowBundle& getBundle(int y, int z) const
    {
        return _bundles[static_cast<std::size_t>(y / RowBundle::SIDE + _numBundles * (z / RowBundle::SIDE))];
    }

    /** The words of a row; zeros outside the grid. */
    const std::uint64_t* getRow(int y, int z) const
    {
        if (y < 0 || z < 0 || y >= _dimensions.y || z >= _dimensions.z) return _nothing.data();
        const RowBundle& bundle = getBundle(y, z);
        return bundle.occupancy.empty() ? _nothing.data() : &bundle.occupancy[RowBundle::rowOf(y, z) * _numWords];
    }

    std::size_t getNumWords() const { return _numWords; }

private:
    const std::vector<RowBundle>& _bundles;
    const glm::ivec3& _dimensions;
    int _numBundles;
    std::size_t _numWords;
    std::vector<std::uint64_t> _nothing;
};

/** Copy the bricks of a row, and compute their open sides. */
void joinRow(const RowOccupancy& occupancy, int y, int z, const Brick* from, Brick* to)
{
    const std::uint64_t* here = occupancy.getRow(y, z);
    const std::array beside{occupancy.getRow(y - 1, z), occupancy.getRow(y + 1, z), occupancy.getRow(y, z - 1),
                            occupancy.getRow(y, z + 1)};
    constexpr int LAST = RowBundle::WORD_BITS - 1;
    const std::size_t numWords = occupancy.getNumWords();
    for (std::size_t word = 0; word < numWords; ++word)
    {
        if (here[word] == 0) continue;
        const std::uint64_t left = here[word] << 1 | (word > 0 ? here[word - 1] >> LAST : 0);
        const std::uint64_t right = here[word] >> 1 | (word + 1 < numWords ? here[word + 1] << LAST : 0);
        const std::array filled{left, right, beside[0][word], beside[1][word], beside[2][word], beside[3][word]};
        for (std::uint64_t rest = here[word]; rest != 0; rest &= rest - 1)
        {
            const int bit = std::countr_zero(rest);
            unsigned int open = 0;
            for (std::size_t side = 0; side < filled.size(); ++side)
                open |= static_cast<unsigned int>(~filled[side] >> bit & 1u) << side;
            *to = *from++;
            to->openSides = static_cast<std::uint8_t>(open);
            ++to;
        }
    }
}

} // namespace

RowBundleSums::RowBundleSums(int width) :
    _width(static_cast<std::size_t>(width)), _numWords(RowBundle::numWords(width)), _sums(RowBundle::NUM_ROWS * _width),
    _occupancy(RowBundle::NUM_ROWS * _numWords)
{
}

RowBundle RowBundleSums::take(const glm::ivec2& firstRow, const PreviousCells* previous)
{
    DominantColors::FindPrevious findPrevious;
    if (previous)
        findPrevious = [&](std::size_t cell)
        {
            const int row = static_cast<int>(cell / _width);
            return previous->findColor(
                {cell % _width, firstRow.x + row % RowBundle::SIDE, firstRow.y + row / RowBundle::SIDE});
        };
    _dominantColors.choose(_sums, findPrevious);
    RowBundle bundle;
    std::size_t count = 0;
    for (const std::uint64_t word : _occupancy)
        count += static_cast<std::size_t>(std::popcount(word));
    bundle.bricks.reserve(count);
    for (std::size_t row = 0; row < RowBundle::NUM_ROWS; ++row)
    {
        bundle.begins[row] = static_cast<std::uint32_t>(bundle.bricks.size());
        const int number = static_cast<int>(row);
        takeRow(row, firstRow + glm::ivec2(number % RowBundle::SIDE, number / RowBundle::SIDE), bundle);
    }
    bundle.begins.back() = static_cast<std::uint32_t>(count);
    if (count > 0) bundle.occupancy = _occupancy;
    std::fill(_occupancy.begin(), _occupancy.end(), 0);
    return bundle;
}

void RowBundleSums::takeRow(std::size_t row, const glm::ivec2& place, RowBundle& bundle)
{
    for (std::size_t word = 0; word < _numWords; ++word)
        for (std::uint64_t rest = _occupancy[row * _numWords + word]; rest != 0; rest &= rest - 1)
        {
            const std::size_t x = word * RowBundle::WORD_BITS + static_cast<std::size_t>(std::countr_zero(rest));
            bundle.bricks.push_back(makeBrick({x, place.x, place.y}, _sums[row * _width + x]));
        }
}

std::vector<Brick> joinBundles(const std::vector<RowBundle>& bundles, const glm::ivec3& dimensions)
{
    const RowOccupancy occupancy(bundles, dimensions);
    std::vector<std::size_t> begins(static_cast<std::size_t>(dimensions.y) * static_cast<std::size_t>(dimensions.z));
    std::size_t count = 0;
    auto begin = begins.begin();
    for (int z = 0; z < dimensions.z; ++z)
        for (int y = 0; y < dimensions.y; ++y)
        {
            *begin++ = count;
            const RowBundle& bundle = occupancy.getBundle(y, z);
            if (bundle.occupancy.empty()) continue;
            const std::size_t row = RowBundle::rowOf(y, z);
            count += bundle.begins[row + 1] - bundle.begins[row];
        }

    std::vector<Brick> bricks(count);
    const auto depth = static_cast<std::size_t>(dimensions.y);
    oneapi::tbb::parallel_for(
        0, dimensions.z,
        [&](int z)
        {
            for (int y = 0; y < dimensions.y; ++y)
            {
                const RowBundle& bundle = occupancy.getBundle(y, z);
                if (bundle.occupancy.empty()) continue;
                const std::size_t first = begins[static_cast<std::size_t>(y) + depth * static_cast<std::size_t>(z)];
                joinRow(occupancy, y, z, bundle.bricks.data() + bundle.begins[RowBundle::rowOf(y, z)],
                        bricks.data() + first);
            }
        });
    return bricks;
}

} // namespace osgLego
