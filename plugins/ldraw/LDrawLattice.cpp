#include "LDrawLattice.h"

#include <cmath>
#include <map>

namespace osgLego
{

namespace
{

// Files have rounded numbers, and rotations that are nearly those by 90 degrees.
constexpr double AXIS_TOLERANCE = 1e-3;
constexpr double PLACE_TOLERANCE = 0.2; // LDU

bool isNear(double value, double expected)
{
    return std::abs(value - expected) < AXIS_TOLERANCE;
}

/** Whether the long side of a part lies along x (false: along z); nothing unless the part is upright, unscaled and
 * turned by a multiple of 90 degrees. Mirrored parts are the same as parts that are turned. */
std::optional<bool> isAlongX(const glm::dmat3& axes)
{
    const bool isUpright = isNear(axes[0][1], 0.0) && isNear(axes[2][1], 0.0) && isNear(axes[1][0], 0.0) &&
                           isNear(axes[1][2], 0.0) && isNear(axes[1][1], 1.0);
    if (!isUpright) return std::nullopt;
    const auto areAxes = [&](int first, int second)
    {
        return isNear(std::abs(axes[0][first]), 1.0) && isNear(axes[0][second], 0.0) &&
               isNear(std::abs(axes[2][second]), 1.0) && isNear(axes[2][first], 0.0);
    };
    if (areAxes(0, 2)) return true;
    if (areAxes(2, 0)) return false;
    return std::nullopt;
}

/** A part as a box along the axes of the cells: sizes in cells, the lowest corner in LDU. */
struct Box
{
    glm::ivec3 size;
    glm::dvec3 corner;
};

std::optional<Box> toUprightBox(const LDrawPart& part)
{
    const std::optional<bool> alongX = isAlongX(part.transform.axes);
    if (!alongX) return std::nullopt;
    const PartType& type = *part.type;
    const int plates = type.family == PartFamily::BRICK ? 3 : 1;
    const glm::ivec3 size(*alongX ? type.length : type.width, *alongX ? type.width : type.length, plates);
    // The origin of a part is the centre of its top face, and LDraw's y points downwards.
    const glm::dvec3& top = part.transform.place;
    return Box{size,
               {top.x - 0.5 * LDrawLattice::STUD * size.x, top.z - 0.5 * LDrawLattice::STUD * size.y,
                -top.y - LDrawLattice::PLATE * plates}};
}

/** The place of a corner within a cell, in tenths of LDU: equal for corners on the same lattice. */
std::array<long, 3> phaseOf(const glm::dvec3& corner)
{
    constexpr double STEPS = 10.0;
    std::array<long, 3> phase{};
    for (int axis = 0; axis < 3; ++axis)
    {
        const double cell = LATTICE_CELL[static_cast<std::size_t>(axis)];
        const double within = corner[axis] - cell * std::floor(corner[axis] / cell);
        phase[static_cast<std::size_t>(axis)] = std::lround(within * STEPS) % std::lround(cell * STEPS);
    }
    return phase;
}

} // namespace

LDrawLattice LDrawLattice::find(std::span<const LDrawPart> parts)
{
    struct Candidate
    {
        std::size_t count = 0;
        std::size_t first = 0; // the index of its first part
        glm::dvec3 corner{0.0};
    };
    std::map<std::array<long, 3>, Candidate> candidates;
    for (std::size_t index = 0; index < parts.size(); ++index)
        if (const std::optional<Box> box = toUprightBox(parts[index]))
        {
            Candidate& candidate = candidates[phaseOf(box->corner)];
            if (candidate.count++ == 0) candidate = {1, index, box->corner};
        }
    Candidate best;
    for (const auto& [phase, candidate] : candidates)
        if (candidate.count > best.count || (candidate.count == best.count && candidate.first < best.first))
            best = candidate;
    LDrawLattice lattice;
    lattice._origin = best.corner;
    return lattice;
}

std::optional<LatticeBox> LDrawLattice::toBox(const LDrawPart& part) const
{
    const std::optional<Box> box = toUprightBox(part);
    if (!box) return std::nullopt;
    LatticeBox result{{}, box->size};
    for (int axis = 0; axis < 3; ++axis)
    {
        const double cell = LATTICE_CELL[static_cast<std::size_t>(axis)];
        const double offset = box->corner[axis] - _origin[axis];
        const double steps = std::round(offset / cell);
        // Parts beyond this distance from each other can't belong to one grid; the limit keeps sums within an int.
        constexpr double FARTHEST = 1e8;
        if (std::abs(offset - steps * cell) > PLACE_TOLERANCE || std::abs(steps) > FARTHEST) return std::nullopt;
        result.place[axis] = static_cast<int>(steps);
    }
    return result;
}

} // namespace osgLego
