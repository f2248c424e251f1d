#include <osgLego/data/StudOcclusion.h>

#include <osgLego/BrickDimensions.h>
#include <osgLego/data/OcclusionFalloff.h>
#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

namespace
{

constexpr int NUM_COLUMNS = 32;
constexpr int BAND = 8; // lines
constexpr double GREATEST = 0.5;
constexpr double FARTHEST = 1.5; // of the columns that are distances, in pitches
constexpr double NEVER = std::numeric_limits<double>::infinity();

/** Cosine-weighted directions around the first axis or the last one, all with the same weight. */
std::vector<glm::dvec3> createHemisphere(bool isUp)
{
    constexpr int ROWS = 40;
    constexpr int COLUMNS = 160;
    std::vector<glm::dvec3> directions;
    for (int row = 0; row < ROWS; ++row)
        for (int column = 0; column < COLUMNS; ++column)
        {
            const double angle = 2.0 * std::numbers::pi * (column + 0.5) / COLUMNS;
            const double square = (row + 0.5) / ROWS; // of the distance from the normal
            const double radius = std::sqrt(square);
            const double across = radius * std::cos(angle);
            const double along = radius * std::sin(angle);
            const double normal = std::sqrt(1.0 - square);
            directions.push_back(isUp ? glm::dvec3(across, along, normal) : glm::dvec3(normal, across, along));
        }
    return directions;
}

/** The distance at which a ray meets a stud that stands on the level 0. */
double findStud(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec2& axis)
{
    constexpr double RADIUS = BrickDimensions::STUD_RADIUS;
    constexpr double HEIGHT = BrickDimensions::STUD_HEIGHT;
    const glm::dvec2 from = glm::dvec2(origin) - axis;
    const glm::dvec2 along(direction);
    const double square = glm::dot(along, along);
    const double half = glm::dot(from, along);
    const double discriminant = half * half - square * (glm::dot(from, from) - RADIUS * RADIUS);
    if (discriminant <= 0.0) return NEVER;
    const double wall = (-half - std::sqrt(discriminant)) / square;
    const double height = origin.z + wall * direction.z;
    if (wall > 0.0 && height >= 0.0 && height <= HEIGHT) return wall;
    const double disk = (HEIGHT - origin.z) / direction.z;
    const glm::dvec2 place = from + disk * along;
    return disk > 0.0 && glm::dot(place, place) < RADIUS * RADIUS ? disk : NEVER;
}

/** The light that a stud hides from a point: its weight and the sum of directions.
 * @param directions the result of createHemisphere(). */
glm::dvec4 sumHidden(const std::vector<glm::dvec3>& directions, const glm::dvec3& point, const glm::dvec2& axis,
                     double radius)
{
    glm::dvec4 sum(0.0);
    for (const glm::dvec3& direction : directions)
    {
        const double distance = findStud(point, direction, axis);
        if (distance == NEVER) continue;
        const double floor = direction.z < 0.0 ? -point.z / direction.z : NEVER;
        // The bricks of both studs are no farther away.
        if (floor * direction.x < axis.x + 0.5) continue;
        sum += fadeOcclusion(distance, radius) * glm::dvec4(1.0, direction.x, direction.y, direction.z);
    }
    return sum / static_cast<double>(directions.size());
}

/** The light that is hidden from the point that a texel stands for. */
glm::dvec4 findHidden(int column, int line, double height, double radius)
{
    constexpr double STUD_RADIUS = BrickDimensions::STUD_RADIUS;
    static const std::vector<glm::dvec3> ahead = createHemisphere(false);
    static const std::vector<glm::dvec3> upward = createHemisphere(true);
    const double across = static_cast<double>(column) / (NUM_COLUMNS - 1);
    const double up = static_cast<double>(line % BAND) / (BAND - 1);
    if (line >= 3 * BAND)
    {
        const glm::dvec4 sum =
            sumHidden(upward, glm::dvec3(0.0), {glm::mix(STUD_RADIUS, FARTHEST, across * across), 0.0}, radius);
        return {sum.x, 0.0, sum.y, sum.w};
    }
    if (line < BAND) return sumHidden(ahead, {0.0, 0.0, up * height}, {0.5, FARTHEST * across}, radius);
    const double distance = line < 2 * BAND ? 1.0 : std::numbers::sqrt2;
    const double cosine = 1.0 - 2.0 * across;
    const glm::dvec2 axis =
        distance * glm::dvec2(cosine, std::sqrt(1.0 - cosine * cosine)) - glm::dvec2(STUD_RADIUS, 0.0);
    return sumHidden(ahead, {0.0, 0.0, up * BrickDimensions::STUD_HEIGHT}, axis, radius);
}

void writeHidden(const glm::dvec4& hidden, unsigned char* bytes)
{
    const glm::dvec4 values(hidden.x / GREATEST, hidden.z / GREATEST, 0.5 + 0.5 * hidden.w / GREATEST,
                            hidden.y / GREATEST);
    for (int channel = 0; channel < 4; ++channel)
        bytes[channel] = static_cast<unsigned char>(std::lround(255.0 * std::clamp(values[channel], 0.0, 1.0)));
}

} // namespace

osg::ref_ptr<osg::Image> createStudOcclusion(double height, double radius)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(NUM_COLUMNS, 4 * BAND, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    const auto fillLine = [&](std::size_t index)
    {
        const auto line = static_cast<int>(index);
        for (int column = 0; column < NUM_COLUMNS; ++column)
            writeHidden(findHidden(column, line, height, radius),
                        image->data(static_cast<unsigned int>(column), static_cast<unsigned int>(line)));
    };
    forEachIndex(4 * BAND, fillLine);
    return image;
}

} // namespace osgLego
