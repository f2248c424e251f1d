#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace osgLego
{

/** The number of cells of a part along x, y and z. */
struct PartShape
{
    std::uint8_t width = 1;
    std::uint8_t depth = 1;
    std::uint8_t height = 1;

    int getNumCells() const { return width * depth * height; }

    bool operator==(const PartShape&) const = default;
};

/** The sizes of parts that a layout may use, in each of its colours.
 *
 * Immutable; may be used from any thread. */
class PartSizes
{
public:
    static constexpr int LONGEST = 8;
    static constexpr int BRICK_PLATES = 3; //!< the height of a brick in plates

    explicit PartSizes(const LayoutProblem& problem);

    /** Whether a part of this shape exists in a colour; for LayoutCell::ANY_COLOR, in at least one. */
    bool isMade(const PartShape& shape, std::uint16_t color) const;
    /** Whether a layout may use it: it exists, or it is a single cell, for which there is no other part. */
    bool isAllowed(const PartShape& shape, std::uint16_t color) const;
    /** The heights of parts in cells: 1, and 3 if three plates may be a brick. */
    const std::vector<int>& getHeights() const { return _heights; }

    /** The colour of a part of two cells; none if their colours differ. */
    static std::optional<std::uint16_t> join(std::uint16_t color, std::uint16_t other)
    {
        if (color == other || other == LayoutCell::ANY_COLOR) return color;
        if (color == LayoutCell::ANY_COLOR) return other;
        return std::nullopt;
    }

private:
    std::vector<std::array<std::uint16_t, 2>> _masks; //!< of each colour, then of any: parts of one cell, and of three
    std::vector<int> _heights;
};

} // namespace osgLego
