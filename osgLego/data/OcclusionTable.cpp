#include <osgLego/data/OcclusionTable.h>

#include <osgLego/data/OcclusionFalloff.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

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
std::vector<glm::dvec3> createDirections()
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

/** The bit of a cell in a pattern. @param cell not the origin. */
unsigned int bitOf(const glm::ivec3& cell)
{
    const int place = cell.x + 2 * cell.y;
    return 1u << (cell.z == 0 ? place - 1 : 4 * cell.z - 1 + place);
}

/** For each set of cells, the sum of (visibility, bent vector) of the directions that no other cell hides. */
class HiddenDirections
{
public:
    HiddenDirections(const glm::dvec3& cell, double radius) : _cell(cell), _radius(radius), _sums(NUM_PATTERNS) {}

    /** @param place in the cell in front of the face, from its corner. */
    void add(const glm::dvec3& place, const glm::dvec3& direction)
    {
        const glm::dvec3 steps = _cell / glm::max(direction, 1e-12);
        glm::dvec3 next = (_cell - place) / glm::max(direction, 1e-12);
        glm::ivec3 cell(0);
        const glm::dvec4 whole(1.0, direction);
        unsigned int passed = 0;
        double rest = 1.0;
        while (true)
        {
            const int axis = next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2;
            const double distance = next[axis];
            cell[axis] += 1;
            next[axis] += steps[axis];
            if (cell.x > 1 || cell.y > 1 || cell.z >= NUM_LAYERS) break;
            // A hit in this cell or in a later one hides at most this fraction; one in an earlier cell hides more.
            const double hidden = fadeOcclusion(distance, _radius);
            _sums[passed] += (rest - hidden) * whole;
            rest = hidden;
            passed |= bitOf(cell);
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
    glm::dvec3 _cell;
    double _radius;
    std::vector<glm::dvec4> _sums; // by the set of cells that hide a direction
};

void write(const glm::dvec4& sum, unsigned char* bytes)
{
    const glm::dvec4 maximum(MAXIMUM.x, MAXIMUM.y, MAXIMUM.y, MAXIMUM.z);
    for (int channel = 0; channel < 4; ++channel)
        bytes[channel] =
            static_cast<unsigned char>(std::lround(255.0 * std::clamp(sum[channel] / maximum[channel], 0.0, 1.0)));
}

/** Fill the texels of a position on a face. @param cell along the axes of the face and along its normal, in pitches. */
void fillPosition(osg::Image& image, int firstLine, const glm::ivec2& position, const glm::dvec3& cell, double radius)
{
    static const std::vector<glm::dvec3> directions = createDirections();
    HiddenDirections hidden(cell, radius);
    // Just inside the cell, so that rays from an edge enter the neighbour that they point to.
    constexpr double INSET = 1e-4;
    const glm::dvec2 place = glm::min(glm::dvec2(position) / double(PATTERN_SIDE - 1), 1.0 - INSET) * glm::dvec2(cell);
    for (const glm::dvec3& direction : directions)
        hidden.add(glm::dvec3(place, 0.0), direction);
    const std::vector<glm::dvec4> sums = hidden.sumByPattern();
    const double share = 0.25 / static_cast<double>(directions.size());
    for (int pattern = 0; pattern < NUM_PATTERNS; ++pattern)
    {
        const int column = pattern % PATTERNS_ACROSS * PATTERN_SIDE + position.x;
        const int line = firstLine + pattern / PATTERNS_ACROSS * PATTERN_SIDE + position.y;
        write(share * sums[static_cast<std::size_t>(pattern)],
              image.data(static_cast<unsigned int>(column), static_cast<unsigned int>(line)));
    }
}

} // namespace

osg::ref_ptr<osg::Image> createOcclusionTable(double height, double radius)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(PATTERNS_ACROSS * PATTERN_SIDE, 2 * LINES, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    // Isolated: while it waits here, the thread must not run tasks of the caller, which may need locks that it holds.
    oneapi::tbb::this_task_arena::isolate(
        [&]
        {
            oneapi::tbb::parallel_for(0, PATTERN_SIDE * PATTERN_SIDE,
                                      [&](int index)
                                      {
                                          const glm::ivec2 position(index % PATTERN_SIDE, index / PATTERN_SIDE);
                                          fillPosition(*image, 0, position, {1.0, 1.0, height}, radius);
                                          fillPosition(*image, LINES, position, {1.0, height, 1.0}, radius);
                                      });
        });
    return image;
}

} // namespace osgLego
