#include <common/BrickRayCaster.h>

#include <osgLego/BrickDimensions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

namespace osgLego
{

namespace
{

using BrickDimensions::STUD_HEIGHT;
using BrickDimensions::STUD_RADIUS;
using BrickDimensions::STUD_SIDES;
// The base-2 logarithm of the number of cells along a block's edge.
constexpr int BLOCK_SHIFT = 2;
constexpr int BLOCK_MASK = (1 << BLOCK_SHIFT) - 1;
// Replaces a slope of 0, to avoid dividing by zero: no ray is long enough for the difference to show.
constexpr double LEAST_SLOPE = 1e-200;
// The distance between a surface and the rays that leave it, in pitches.
constexpr double SURFACE_OFFSET = 1e-4;

std::uint64_t bitOf(const glm::ivec3& cell)
{
    const int x = cell.x & BLOCK_MASK;
    const int y = cell.y & BLOCK_MASK;
    const int z = cell.z & BLOCK_MASK;
    return std::uint64_t{1} << (x | y << BLOCK_SHIFT | z << (2 * BLOCK_SHIFT));
}

/** A segment of a ray: distances from the ray's origin. */
struct Stretch
{
    double begin = 0.0;
    double end = 0.0;

    /** Clip the segment to where a coordinate, `place` at the origin and rising by `slope`, is from -half to half. */
    void clip(double place, double slope, double half)
    {
        if (slope == 0.0)
        {
            if (std::abs(place) > half) end = -1.0;
            return;
        }
        const double middle = -place / slope;
        const double reach = std::abs(half / slope);
        begin = std::max(begin, middle - reach);
        end = std::min(end, middle + reach);
    }
};

/** The normals of one side of each pair of opposite sides of a stud. */
const std::array<glm::dvec2, STUD_SIDES / 2> STUD_NORMALS = []
{
    std::array<glm::dvec2, STUD_SIDES / 2> normals{};
    for (std::size_t side = 0; side < normals.size(); ++side)
    {
        const double angle = 2.0 * std::numbers::pi * (static_cast<double>(side) + 0.5) / STUD_SIDES;
        normals[side] = {std::cos(angle), std::sin(angle)};
    }
    return normals;
}();
/** The distance from a stud's axis to its sides. */
const double STUD_APOTHEM = STUD_RADIUS * std::cos(std::numbers::pi / STUD_SIDES);

/** The path of a ray through the cells of a grid, in cell units (Amanatides and Woo, A Fast Voxel Traversal Algorithm
 * for Ray Tracing, 1987). It can skip empty blocks. */
class GridWalk
{
public:
    GridWalk(const glm::dvec3& origin, const glm::dvec3& direction, const glm::ivec3& dimensions,
             double maximumDistance) :
        _origin(origin),
        _direction(direction), _dimensions(dimensions), _maximumDistance(maximumDistance)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            if (std::abs(_direction[axis]) < LEAST_SLOPE) _direction[axis] = LEAST_SLOPE;
            _forward[axis] = _direction[axis] > 0.0 ? 1 : 0;
        }
        _inverse = 1.0 / _direction;
    }

    const glm::ivec3& getCell() const { return _cell; }
    /** The distance at which the ray enters the cell. */
    double getDistance() const { return _distance; }

    /** Go to the first cell on the path. @return false if there is none up to the maximum distance. */
    bool enterGrid()
    {
        double leave = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis)
        {
            const double lower = -_origin[axis] * _inverse[axis];
            const double upper = (_dimensions[axis] - _origin[axis]) * _inverse[axis];
            _distance = std::max(_distance, std::min(lower, upper));
            leave = std::min(leave, std::max(lower, upper));
        }
        if (_distance >= leave || _distance > _maximumDistance) return false;
        for (int axis = 0; axis < 3; ++axis)
        {
            _cell[axis] = findPlace(axis, 0, _dimensions[axis] - 1);
            _next[axis] = distanceTo(axis, _cell[axis] + _forward[axis]);
        }
        return true;
    }

    /** Go to the next cell. @return false if there is none up to the maximum distance. */
    bool leaveCell()
    {
        const int axis = findLeast(_next);
        _distance = _next[axis];
        _cell[axis] += 2 * _forward[axis] - 1;
        _next[axis] = distanceTo(axis, _cell[axis] + _forward[axis]);
        return isOnTheWay(axis);
    }

    /** Go to the next cell outside the current block. @return false if there is none up to the maximum distance. */
    bool leaveBlock()
    {
        glm::ivec3 last;
        glm::dvec3 ends;
        for (int axis = 0; axis < 3; ++axis)
        {
            last[axis] = _forward[axis] ? _cell[axis] | BLOCK_MASK : _cell[axis] & ~BLOCK_MASK;
            ends[axis] = distanceTo(axis, last[axis] + _forward[axis]);
        }
        const int through = findLeast(ends);
        _distance = ends[through];
        for (int axis = 0; axis < 3; ++axis)
        {
            // Despite rounding, never step backwards or into a block that shares only an edge.
            const int low = std::min(_cell[axis], last[axis]);
            const int high = std::max(_cell[axis], last[axis]);
            _cell[axis] = axis == through ? last[axis] + 2 * _forward[axis] - 1 : findPlace(axis, low, high);
            _next[axis] = distanceTo(axis, _cell[axis] + _forward[axis]);
        }
        return isOnTheWay(through);
    }

private:
    static int findLeast(const glm::dvec3& values)
    {
        if (values.x < values.y) return values.x < values.z ? 0 : 2;
        return values.y < values.z ? 1 : 2;
    }

    double distanceTo(int axis, int face) const { return (face - _origin[axis]) * _inverse[axis]; }

    int findPlace(int axis, int low, int high) const
    {
        // Truncation rounds down: only rounding errors make the coordinate negative.
        const double place = _origin[axis] + _distance * _direction[axis];
        return static_cast<int>(std::clamp(place, static_cast<double>(low), static_cast<double>(high)));
    }

    bool isOnTheWay(int movedAxis) const
    {
        return _cell[movedAxis] >= 0 && _cell[movedAxis] < _dimensions[movedAxis] && _distance <= _maximumDistance;
    }

    glm::dvec3 _origin;
    glm::dvec3 _direction;
    glm::dvec3 _inverse;
    glm::ivec3 _forward{0}; // 1 along axes on which the ray ascends
    glm::ivec3 _dimensions;
    double _maximumDistance;
    glm::ivec3 _cell{0};
    glm::dvec3 _next{0.0}; // the distance at which the ray leaves the cell along each axis
    double _distance = 0.0;
};

/** A pseudo-random offset for each seed, 0 to 1 in both coordinates. */
glm::dvec2 rotationOf(std::uint32_t seed)
{
    // The steps of splitmix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014).
    std::uint64_t bits = (seed + std::uint64_t{1}) * 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    bits ^= bits >> 31;
    constexpr double UNIT = 0x1p-32;
    return {static_cast<double>(bits >> 32) * UNIT, static_cast<double>(bits & 0xffffffffu) * UNIT};
}

/** One of `numRays` cosine-weighted directions around +z: a rotated golden-ratio lattice on a disk, projected up to the
 * hemisphere. */
glm::dvec3 directionOf(int ray, int numRays, const glm::dvec2& rotation)
{
    const double share = glm::fract((ray + 0.5) / numRays + rotation.x);
    const double angle = 2.0 * std::numbers::pi * glm::fract(ray / std::numbers::phi + rotation.y);
    const double radius = std::sqrt(share);
    return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0 - share)};
}

/** A rotation that takes +z to `normal`. */
glm::dmat3 frameAround(const glm::dvec3& normal)
{
    const glm::dvec3 across = std::abs(normal.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(across, normal));
    return {tangent, glm::cross(normal, tangent), normal};
}

} // namespace

BrickRayCaster::BrickRayCaster(const BrickModel& model) :
    _model(&model), _up(model.getGrid().getUpIndex()),
    _cellExtent(model.getGrid().cellSize / model.getGrid().getPitch()), _dimensions(model.getGrid().dimensions)
{
    ++_dimensions[_up];
    _blocks = SparseBox<Block>((_dimensions + BLOCK_MASK) >> BLOCK_SHIFT);
    for (const Brick& brick : model.getBricks())
    {
        glm::ivec3 cell(brick.cell[0], brick.cell[1], brick.cell[2]);
        _blocks.edit(cell >> BLOCK_SHIFT).covered |= bitOf(cell);
        ++cell[_up];
        if (brick.openSides & (SIDE_RIGHT << (2 * _up))) _blocks.edit(cell >> BLOCK_SHIFT).studs |= bitOf(cell);
    }
}

glm::dvec3 BrickRayCaster::toCaster(const osg::Vec3d& point) const
{
    return (glm::dvec3(point.x(), point.y(), point.z()) - _model->getGrid().origin) / getPitch();
}

std::optional<double> BrickRayCaster::findNearest(const glm::dvec3& origin, const glm::dvec3& direction,
                                                  double maximumDistance) const
{
    GridWalk walk(origin / _cellExtent, direction / _cellExtent, _dimensions, maximumDistance);
    bool isOnTheWay = walk.enterGrid();
    while (isOnTheWay)
    {
        const glm::ivec3& cell = walk.getCell();
        const Block& block = _blocks.get(cell >> BLOCK_SHIFT);
        if ((block.covered | block.studs) == 0)
        {
            isOnTheWay = walk.leaveBlock();
            continue;
        }
        const std::uint64_t bit = bitOf(cell);
        if (block.covered & bit) return walk.getDistance();
        if (block.studs & bit)
            if (const auto distance = findStud(cell, origin, direction, maximumDistance)) return distance;
        isOnTheWay = walk.leaveCell();
    }
    return std::nullopt;
}

std::optional<double> BrickRayCaster::findStud(const glm::ivec3& cell, const glm::dvec3& origin,
                                               const glm::dvec3& direction, double maximumDistance) const
{
    const int u = (_up + 1) % 3;
    const int v = (_up + 2) % 3;
    const glm::dvec2 place(origin[u] - cell[u] - 0.5, origin[v] - cell[v] - 0.5);
    const glm::dvec2 slope(direction[u], direction[v]);
    // Most rays miss even the circle around the stud, a test that needs no division.
    const double moment = place.x * slope.y - place.y * slope.x;
    constexpr double SQUARED_RADIUS = STUD_RADIUS * STUD_RADIUS;
    if (moment * moment > SQUARED_RADIUS * glm::dot(slope, slope)) return std::nullopt;

    Stretch stretch{0.0, maximumDistance};
    constexpr double HALF_HEIGHT = 0.5 * STUD_HEIGHT;
    stretch.clip(origin[_up] - cell[_up] * _cellExtent[_up] - HALF_HEIGHT, direction[_up], HALF_HEIGHT);
    for (const glm::dvec2& normal : STUD_NORMALS)
    {
        if (stretch.begin > stretch.end) return std::nullopt;
        stretch.clip(glm::dot(normal, place), glm::dot(normal, slope), STUD_APOTHEM);
    }
    return stretch.begin <= stretch.end ? std::optional(stretch.begin) : std::nullopt;
}

BrickRayCaster::Occlusion BrickRayCaster::sampleOcclusion(const glm::dvec3& point, const glm::dvec3& normal,
                                                          double radius, double falloff, int numRays,
                                                          std::uint32_t seed) const
{
    const glm::dvec3 origin = point + SURFACE_OFFSET * normal;
    const glm::dmat3 frame = frameAround(normal);
    const glm::dvec2 rotation = rotationOf(seed);
    double sum = 0.0;
    glm::dvec3 bend(0.0);
    for (int ray = 0; ray < numRays; ++ray)
    {
        const glm::dvec3 direction = frame * directionOf(ray, numRays, rotation);
        const auto distance = findNearest(origin, direction, radius);
        const double shut = distance ? std::clamp((radius - *distance) / (radius * falloff), 0.0, 1.0) : 0.0;
        sum += 1.0 - shut;
        bend += (1.0 - shut) * direction;
    }
    const double length = glm::length(bend);
    return {sum / numRays, length > 0.0 ? bend / length : normal};
}

} // namespace osgLego
