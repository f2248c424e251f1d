#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/cpu/DominantColors.h>
#include <osgLego/cpu/PreviousCells.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

/** The covered cells of a bundle of rows: SIDE x SIDE rows of cells along x, adjacent in y and z.
 *
 * Rows are numbered from 0, y first. */
struct RowBundle
{
    static constexpr int SIDE = 8;
    static constexpr std::size_t NUM_ROWS = SIDE * SIDE;
    static constexpr int WORD_BITS = 64;

    std::vector<Brick> bricks;                      //!< row by row, each sorted by x; openSides are not set yet
    std::vector<std::uint64_t> occupancy;           //!< one bit per cell, row by row; empty if there are no bricks
    std::array<std::uint32_t, NUM_ROWS + 1> begins; //!< the first brick of each row, then the number of all

    static std::size_t rowOf(int y, int z)
    {
        return static_cast<unsigned int>(y) % SIDE + SIDE * (static_cast<unsigned int>(z) % SIDE);
    }
    /** The number of occupancy words in a row of `width` cells. */
    static std::size_t numWords(int width) { return static_cast<std::size_t>((width + WORD_BITS - 1) / WORD_BITS); }
};

/** Sums the weighted colours that triangles contribute to the cells of one bundle. Reusable for the next bundle.
 *
 * One thread at a time. */
class RowBundleSums
{
public:
    /** @param width cells along x. */
    explicit RowBundleSums(int width);

    /** Add a colour, 0 to 1 per channel, to a cell of the bundle. @param weight above 0. */
    void add(const glm::ivec3& cell, float weight, const glm::vec3& color)
    {
        const std::size_t row = RowBundle::rowOf(cell.y, cell.z);
        const auto x = static_cast<std::size_t>(cell.x);
        std::uint64_t& word = _occupancy[row * _numWords + x / RowBundle::WORD_BITS];
        const std::uint64_t bit = std::uint64_t(1) << x % RowBundle::WORD_BITS;
        glm::vec4& sum = _sums[row * _width + x];
        const glm::vec4 addend(weight * color, weight);
        // Sums of the previous bundle are overwritten rather than cleared.
        sum = (word & bit) != 0 ? sum + addend : addend;
        word |= bit;
    }

    /** Add a candidate for the colour of a cell, which then has one of its candidates instead of their mean. */
    void addCandidate(const glm::ivec3& cell, const glm::vec3& color)
    {
        _dominantColors.add(RowBundle::rowOf(cell.y, cell.z) * _width + static_cast<std::size_t>(cell.x), color);
    }

    /** Return the bricks, and start again without any.
     * @param firstRow y and z of the bundle's first row.
     * @param previous the bricks before, whose colours are preferred; null if there are none. */
    RowBundle take(const glm::ivec2& firstRow, const PreviousCells* previous);

private:
    void takeRow(std::size_t row, const glm::ivec2& place, RowBundle& bundle);

    std::size_t _width;
    std::size_t _numWords;
    std::vector<glm::vec4> _sums; // weighted colours, and weights
    DominantColors _dominantColors;
    std::vector<std::uint64_t> _occupancy;
};

/** The bricks of all bundles of a grid, with their open sides, sorted as in a BrickModel.
 * @param bundles ordered along y first, then z; SIDE rows each. */
std::vector<Brick> joinBundles(const std::vector<RowBundle>& bundles, const glm::ivec3& dimensions);

} // namespace osgLego
