#include <osgLego/data/OcclusionTable.h>

#include <osgLego/data/OcclusionCurve.h>
#include <osgLego/data/OcclusionFalloff.h>
#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

namespace
{

constexpr int DIRECTIONS_ACROSS = 24; // of a square that is mapped onto a quadrant
constexpr int NUM_LAYERS = 3;
constexpr int PATTERN_SIDE = 8; // texels of a pattern, along each axis
constexpr int NUM_PATTERNS = 2048;
constexpr int PATTERNS_ACROSS = 64;
constexpr int LINES = NUM_PATTERNS / PATTERNS_ACROSS * PATTERN_SIDE;

// The integrals of cosine / pi over a quadrant, alone and times the components of the direction.
const glm::dvec3 MAXIMUM(0.25, 1.0 / (3.0 * std::numbers::pi), 1.0 / 6.0);

/** Cosine-weighted directions of a quadrant, all with the same weight. */
std::vector<glm::dvec3> createQuadrant()
{
    std::vector<glm::dvec3> directions;
    for (int row = 0; row < DIRECTIONS_ACROSS; ++row)
        for (int column = 0; column < DIRECTIONS_ACROSS; ++column)
        {
            const double angle = 0.5 * std::numbers::pi * (column + 0.5) / DIRECTIONS_ACROSS;
            const double square = (row + 0.5) / DIRECTIONS_ACROSS; // of the distance from the normal
            const double radius = std::sqrt(square);
            directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0 - square));
        }
    return directions;
}

/** Likewise, of all quadrants. */
std::vector<glm::dvec3> createHemisphere()
{
    std::vector<glm::dvec3> directions;
    for (const glm::dvec3& direction : createQuadrant())
        for (const glm::dvec3& sides : {glm::dvec3(1, 1, 1), {-1, 1, 1}, {1, -1, 1}, {-1, -1, 1}})
            directions.push_back(sides * direction);
    return directions;
}

/** The bit of a cell in a pattern. @param cell not the origin. */
unsigned int bitOf(const glm::ivec3& cell)
{
    const int place = cell.x + 2 * cell.y;
    return 1u << (cell.z == 0 ? place - 1 : 4 * cell.z - 1 + place);
}

/** The cells around those of a pattern. */
enum class Surroundings
{
    EMPTY,
    REPEATED //!< each is like the nearest one of the pattern in its layer
};

/** For each set of cells, the sum of (visibility, bent vector) of the directions that no other cell hides. */
class HiddenDirections
{
public:
    HiddenDirections(const glm::dvec3& extent, double radius, Surroundings surroundings) :
        _extent(extent), _radius(radius), _surroundings(surroundings), _sums(NUM_PATTERNS)
    {
    }

    /** @param cell in front of the place, relative to that of the pattern. @param place in the cell, from its corner.
     */
    void add(glm::ivec3 cell, const glm::dvec3& place, const glm::dvec3& direction)
    {
        const glm::dvec3 lengths = glm::max(glm::abs(direction), 1e-12);
        const glm::dvec3 steps = _extent / lengths;
        const glm::bvec3 isUpward = glm::greaterThan(direction, glm::dvec3(0.0));
        glm::dvec3 next = glm::mix(place, _extent - place, isUpward) / lengths;
        const glm::dvec4 whole(1.0, direction);
        unsigned int passed = 0;
        double rest = 1.0;
        while (true)
        {
            const int axis = next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2;
            const double distance = next[axis];
            cell[axis] += isUpward[axis] ? 1 : -1;
            next[axis] += steps[axis];
            if (distance >= _radius || cell.z >= NUM_LAYERS) break;
            if (_surroundings == Surroundings::EMPTY && (cell.x > 1 || cell.y > 1)) break;
            const glm::ivec3 like = glm::clamp(cell, glm::ivec3(0), glm::ivec3(1, 1, NUM_LAYERS - 1));
            if (like == glm::ivec3(0)) continue;
            // A hit in this cell or in a later one hides at most this fraction; one in an earlier cell hides more.
            const double hidden = fadeOcclusion(distance, _radius);
            _sums[passed] += (rest - hidden) * whole;
            rest = hidden;
            passed |= bitOf(like);
        }
        _sums[passed] += rest * whole;
    }

    /** The sums for each pattern of covered cells: of the directions that none of them hides. */
    std::vector<glm::dvec4> sumByPattern() const
    {
        std::vector<glm::dvec4> sums = _sums;
        for (unsigned int bit = 1; bit < sums.size(); bit *= 2)
            for (unsigned int set = 0; set < sums.size(); ++set)
                if (set & bit) sums[set] += sums[set ^ bit];
        // A direction is seen if its cells are among those that are not covered.
        std::reverse(sums.begin(), sums.end());
        return sums;
    }

private:
    glm::dvec3 _extent;
    double _radius;
    Surroundings _surroundings;
    std::vector<glm::dvec4> _sums; // by the set of cells that hide a direction
};

/** The sums of the directions of a quadrant that each pattern of covered cells leaves open, as fractions of a sky.
 * @param place from the corner of the cell. */
std::vector<glm::dvec4> sumQuadrant(const glm::dvec3& extent, double radius, const glm::dvec2& place)
{
    static const std::vector<glm::dvec3> directions = createQuadrant();
    HiddenDirections hidden(extent, radius, Surroundings::EMPTY);
    for (const glm::dvec3& direction : directions)
        hidden.add(glm::ivec3(0), glm::dvec3(place, 0.0), direction);
    std::vector<glm::dvec4> sums = hidden.sumByPattern();
    for (glm::dvec4& sum : sums)
        sum *= 0.25 / static_cast<double>(directions.size());
    return sums;
}

/** The visible fraction of the sky for each pattern of covered cells, which their surroundings repeat.
 * @param place from the corner of the cell (0, 0, 0), less than two cells away. */
std::vector<double> findVisibility(const glm::dvec3& extent, double radius, const glm::dvec2& place)
{
    static const std::vector<glm::dvec3> directions = createHemisphere();
    HiddenDirections hidden(extent, radius, Surroundings::REPEATED);
    const glm::ivec2 cell(glm::floor(place / glm::dvec2(extent)));
    for (const glm::dvec3& direction : directions)
        hidden.add({cell, 0}, glm::dvec3(place - glm::dvec2(cell) * glm::dvec2(extent), 0.0), direction);
    std::vector<double> visibility;
    for (const glm::dvec4& sum : hidden.sumByPattern())
        visibility.push_back(sum.x / static_cast<double>(directions.size()));
    return visibility;
}

bool isCovered(unsigned int pattern, const glm::ivec3& cell)
{
    return cell != glm::ivec3(0) && (pattern & bitOf(cell)) != 0;
}

/** For each pattern, the one whose cells on the upper end of an axis are like those on the lower one. */
using RepeatedPatterns = std::array<unsigned int, NUM_PATTERNS>;

unsigned int repeat(unsigned int pattern, int axis)
{
    unsigned int repeated = 0;
    for (int z = 0; z < NUM_LAYERS; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x)
            {
                const glm::ivec3 cell(x, y, z);
                glm::ivec3 like = cell;
                like[axis] = 0;
                if (isCovered(pattern, like)) repeated |= bitOf(cell);
            }
    return repeated;
}

RepeatedPatterns repeatAll(int axis)
{
    RepeatedPatterns patterns;
    for (unsigned int pattern = 0; pattern < NUM_PATTERNS; ++pattern)
        patterns[pattern] = repeat(pattern, axis);
    return patterns;
}

/** The difference between visibility and its interpolation between the middles of four faces in a plane. */
class InterpolationError
{
public:
    InterpolationError(const glm::dvec3& extent, double radius) : _extent(extent), _radius(radius)
    {
        for (int cell = 0; cell < 4; ++cell)
        {
            std::vector<double>& middles = _middles[static_cast<std::size_t>(cell)];
            middles = findVisibility(extent, radius, (glm::dvec2(cell & 1, cell >> 1) + 0.5) * glm::dvec2(extent));
            for (double& middle : middles)
                middle = OcclusionCurve::encode(1.0 - middle);
        }
    }

    /** Find the difference for each pattern. Towards the middle of the face, the upper cells along an axis become like
     * the lower ones, since the other half of the face does not know them: so it does not change abruptly there.
     * @param share of the way from the middle of the face to its upper ends, 0 to 1. */
    std::vector<double> find(const glm::dvec2& share) const
    {
        // Just inside the cell, so that rays from an edge enter the neighbour that they point to.
        constexpr double INSET = 1e-4;
        const glm::dvec2 place = glm::min(0.5 + 0.5 * share, 1.0 - INSET) * glm::dvec2(_extent);
        const std::vector<double> exact = findVisibility(_extent, _radius, place);
        std::vector<double> differences;
        for (unsigned int pattern = 0; pattern < NUM_PATTERNS; ++pattern)
            differences.push_back(exact[pattern] - 1.0 + OcclusionCurve::decode(interpolate(pattern, 0.5 * share)));
        const glm::dvec2 known = glm::smoothstep(0.0, 0.5, share);
        std::vector<double> errors;
        for (unsigned int pattern = 0; pattern < NUM_PATTERNS; ++pattern)
        {
            const unsigned int first = _alongFirst[pattern];
            errors.push_back(
                glm::mix(glm::mix(differences[_alongSecond[first]], differences[_alongSecond[pattern]], known.x),
                         glm::mix(differences[first], differences[pattern], known.x), known.y));
        }
        return errors;
    }

private:
    double interpolate(unsigned int pattern, const glm::dvec2& share) const
    {
        return glm::mix(glm::mix(get(pattern, {0, 0}), get(pattern, {1, 0}), share.x),
                        glm::mix(get(pattern, {0, 1}), get(pattern, {1, 1}), share.x), share.y);
    }

    /** The occlusion of the middle of a face, encoded. */
    double get(unsigned int pattern, const glm::ivec2& cell) const
    {
        const auto at = [&](int x, int y) { return _middles[static_cast<std::size_t>(x + 2 * y)][pattern]; };
        const bool isFirst = isCovered(pattern, {1, 0, 0});
        const bool isSecond = isCovered(pattern, {0, 1, 0});
        // Nothing is interpolated across a covered cell beside the face.
        if ((cell.x == 0 || isFirst) && (cell.y == 0 || isSecond)) return at(0, 0);
        if (cell.y == 0 || isSecond) return at(1, 0);
        if (cell.x == 0 || isFirst) return at(0, 1);
        // A covered cell at the corner has the mean of those around it.
        return isCovered(pattern, {1, 1, 0}) ? 0.5 * (at(1, 0) + at(0, 1)) : at(1, 1);
    }

    glm::dvec3 _extent;
    double _radius;
    std::array<std::vector<double>, 4> _middles; // the occlusion of the middles of faces, encoded
    RepeatedPatterns _alongFirst = repeatAll(0);
    RepeatedPatterns _alongSecond = repeatAll(1);
};

unsigned char toByte(double fraction)
{
    return static_cast<unsigned char>(std::lround(255.0 * std::clamp(fraction, 0.0, 1.0)));
}

/** Writes the entries for one kind of faces. */
class TableWriter
{
public:
    /** @param cell along the axes of the face and along its normal, in pitches. */
    TableWriter(osg::Image& image, int firstLine, const glm::dvec3& cell, double radius) :
        _image(image), _firstLine(firstLine), _cell(cell), _radius(radius), _error(cell, radius)
    {
    }

    /** Fill the texels of a position on a face, and those of a position on its upper quarter. */
    void fill(const glm::ivec2& position) const
    {
        // Just inside the cell, so that rays from an edge enter the neighbour that they point to.
        constexpr double INSET = 1e-4;
        const glm::dvec2 place = glm::dvec2(position) / double(PATTERN_SIDE - 1);
        const std::vector<glm::dvec4> sums =
            sumQuadrant(_cell, _radius, glm::min(place, 1.0 - INSET) * glm::dvec2(_cell));
        const std::vector<double> errors = _error.find(place);
        for (unsigned int pattern = 0; pattern < NUM_PATTERNS; ++pattern)
        {
            const glm::dvec4& sum = sums[pattern];
            unsigned char* texel = find(pattern, position);
            texel[0] = toByte(sum.x / MAXIMUM.x);
            texel[1] = toByte(sum.y / MAXIMUM.y);
            texel[2] = toByte(sum.z / MAXIMUM.y);
            texel[3] = toByte(sum.w / MAXIMUM.z);
            std::fill_n(find(pattern, position + glm::ivec2(0, 2 * LINES)), 4, toByte(errors[pattern] + 128.0 / 255.0));
        }
    }

private:
    unsigned char* find(unsigned int pattern, const glm::ivec2& position) const
    {
        const unsigned int column = pattern % PATTERNS_ACROSS * PATTERN_SIDE + static_cast<unsigned int>(position.x);
        const unsigned int line =
            pattern / PATTERNS_ACROSS * PATTERN_SIDE + static_cast<unsigned int>(_firstLine + position.y);
        return _image.data(column, line);
    }

    osg::Image& _image;
    int _firstLine;
    glm::dvec3 _cell;
    double _radius;
    InterpolationError _error;
};

} // namespace

osg::ref_ptr<osg::Image> createOcclusionTable(double height, double radius)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(PATTERNS_ACROSS * PATTERN_SIDE, 4 * LINES, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    const TableWriter level(*image, 0, {1.0, 1.0, height}, radius);
    const TableWriter sides(*image, LINES, {1.0, height, 1.0}, radius);
    forEachIndex(PATTERN_SIDE * PATTERN_SIDE,
                 [&](std::size_t index)
                 {
                     const auto place = static_cast<int>(index);
                     const glm::ivec2 position(place % PATTERN_SIDE, place / PATTERN_SIDE);
                     level.fill(position);
                     sides.fill(position);
                 });
    return image;
}

} // namespace osgLego
