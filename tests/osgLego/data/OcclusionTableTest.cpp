#include <osgLego/data/OcclusionCurve.h>
#include <osgLego/data/OcclusionFalloff.h>
#include <osgLego/data/OcclusionTable.h>

#include <cmath>
#include <numbers>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double RADIUS = 2.5;

/** The bit of a cell of a quadrant in a pattern, as the header states it. */
int bitAt(const glm::ivec3& cell)
{
    constexpr int FIRST_LAYER[2][2] = {{-1, 1}, {0, 2}};
    constexpr int OTHERS[2][2] = {{0, 2}, {1, 3}};
    return cell.z == 0 ? FIRST_LAYER[cell.x][cell.y] : 3 + 4 * (cell.z - 1) + OTHERS[cell.x][cell.y];
}

/** The light of a quadrant that reaches a point, and its vector, by random rays in small steps. */
glm::dvec4 castRays(int pattern, const glm::dvec3& point, const glm::dvec3& extent)
{
    constexpr int NUM_RAYS = 4000;
    constexpr double STEP = 0.004;
    std::mt19937 random(static_cast<unsigned int>(pattern));
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    glm::dvec4 sum(0.0);
    for (int ray = 0; ray < NUM_RAYS; ++ray)
    {
        const double square = uniform(random);
        const double angle = 0.5 * std::numbers::pi * uniform(random);
        const glm::dvec3 direction(std::sqrt(square) * std::cos(angle), std::sqrt(square) * std::sin(angle),
                                   std::sqrt(1.0 - square));
        double open = 1.0;
        for (double distance = 0.5 * STEP; distance < RADIUS && open == 1.0; distance += STEP)
        {
            const glm::ivec3 cell(glm::floor((point + distance * direction) / extent));
            if (cell.x > 1 || cell.y > 1 || cell.z > 2) break;
            if (cell != glm::ivec3(0) && (pattern >> bitAt(cell) & 1) != 0)
                open = 1.0 - fadeOcclusion(distance, RADIUS);
        }
        sum += open * glm::dvec4(1.0, direction);
    }
    return 0.25 / NUM_RAYS * sum;
}

/** The entry of a table for a pattern and a texel. */
glm::dvec4 readEntry(const osg::Image& table, int pattern, const glm::ivec2& place, bool isSide)
{
    const int column = 8 * (pattern % 64) + place.x;
    const int line = 8 * (pattern / 64) + place.y + (isSide ? table.t() / 4 : 0);
    const unsigned char* texel = table.data(static_cast<unsigned int>(column), static_cast<unsigned int>(line));
    const double bent = 1.0 / (3.0 * std::numbers::pi);
    return glm::dvec4(texel[0] * 0.25, texel[1] * bent, texel[2] * bent, texel[3] / 6.0) / 255.0;
}

TEST(OcclusionTable, HasTheLightThatRaysFindForEachPattern)
{
    std::mt19937 random(3);
    for (const double height : {1.0, 1.2, 0.4})
    {
        const osg::ref_ptr<osg::Image> table = createOcclusionTable(height, RADIUS);
        ASSERT_EQ(table->s(), 512);
        ASSERT_EQ(table->t(), 1024);
        for (int count = 0; count < 60; ++count)
        {
            const auto pattern = static_cast<int>(random() % 2048);
            const glm::ivec2 place(static_cast<int>(random() % 8), static_cast<int>(random() % 7));
            const bool isSide = count % 2 == 1;
            const glm::dvec3 extent = isSide ? glm::dvec3(1.0, height, 1.0) : glm::dvec3(1.0, 1.0, height);
            const glm::dvec3 point(place.x / 7.0, place.y / 7.0 * extent.y, 0.0);
            // At the border of the cell, on its inner side.
            const glm::dvec3 inner = glm::min(point, extent - 1e-4);
            const glm::dvec4 expected = castRays(pattern, inner, extent);
            const glm::dvec4 found = readEntry(*table, pattern, place, isSide);
            for (int channel = 0; channel < 4; ++channel)
                EXPECT_NEAR(found[channel], expected[channel], 0.008)
                    << pattern << " at " << place.x << ' ' << place.y << ", " << channel << ", height " << height;
        }
    }
}

/** The difference from interpolated visibility of a pattern and a texel. */
double readDifference(const osg::Image& table, int pattern, const glm::ivec2& place, bool isSide)
{
    const int column = 8 * (pattern % 64) + place.x;
    const int line = 8 * (pattern / 64) + place.y + table.t() / 4 * (isSide ? 3 : 2);
    return (table.data(static_cast<unsigned int>(column), static_cast<unsigned int>(line))[0] - 128) / 255.0;
}

/** The light that is hidden from a point by cells that repeat a pattern, by random rays in small steps. */
double castRaysAround(int pattern, const glm::dvec3& point, const glm::dvec3& extent)
{
    constexpr int NUM_RAYS = 4000;
    constexpr double STEP = 0.01;
    std::mt19937 random(static_cast<unsigned int>(pattern));
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    double sum = 0.0;
    for (int ray = 0; ray < NUM_RAYS; ++ray)
    {
        const double square = uniform(random);
        const double angle = 2.0 * std::numbers::pi * uniform(random);
        const glm::dvec3 direction(std::sqrt(square) * std::cos(angle), std::sqrt(square) * std::sin(angle),
                                   std::sqrt(1.0 - square));
        for (double distance = 0.5 * STEP; distance < RADIUS; distance += STEP)
        {
            const glm::ivec3 cell(glm::floor((point + distance * direction) / extent));
            if (cell.z > 2) break;
            const glm::ivec3 like = glm::clamp(cell, glm::ivec3(0), glm::ivec3(1, 1, 2));
            if (like == glm::ivec3(0) || (pattern >> bitAt(like) & 1) == 0) continue;
            sum += fadeOcclusion(distance, RADIUS);
            break;
        }
    }
    return sum / NUM_RAYS;
}

TEST(OcclusionTable, DifferencesLeadFromOcclusionBetweenTheMiddlesOfFacesToThatOfThePoint)
{
    std::mt19937 random(4);
    for (const bool isSide : {false, true})
    {
        const osg::ref_ptr<osg::Image> table = createOcclusionTable(1.2, RADIUS);
        const glm::dvec3 extent = isSide ? glm::dvec3(1.0, 1.2, 1.0) : glm::dvec3(1.0, 1.0, 1.2);
        for (int count = 0; count < 40; ++count)
        {
            // The first layer is open, so that there are four faces beside each other.
            const int pattern = static_cast<int>(random() % 256) << 3;
            const glm::ivec2 place(4 + static_cast<int>(random() % 4), 4 + static_cast<int>(random() % 4));
            const glm::dvec2 share = 0.5 * glm::dvec2(place) / 7.0;
            const auto encodeMiddle = [&](int x, int y) {
                return OcclusionCurve::encode(
                    castRaysAround(pattern, glm::dvec3(x + 0.5, y + 0.5, 0.0) * extent, extent));
            };
            const double lower = glm::mix(encodeMiddle(0, 0), encodeMiddle(1, 0), share.x);
            const double upper = glm::mix(encodeMiddle(0, 1), encodeMiddle(1, 1), share.x);
            const double interpolated = OcclusionCurve::decode(glm::mix(lower, upper, share.y));
            const glm::dvec3 point = glm::min(glm::dvec3(0.5 + share, 0.0), 1.0 - 1e-4) * extent;
            EXPECT_NEAR(readDifference(*table, pattern, place, isSide),
                        interpolated - castRaysAround(pattern, point, extent), 0.03)
                << pattern << " at " << place.x << ' ' << place.y << (isSide ? ", side" : "");
        }
    }
}

TEST(OcclusionTable, DifferencesVanishInTheMiddleOfAFace)
{
    const osg::ref_ptr<osg::Image> table = createOcclusionTable(1.2, RADIUS);
    for (const bool isSide : {false, true})
        for (int pattern = 0; pattern < 2048; ++pattern)
            ASSERT_EQ(readDifference(*table, pattern, {0, 0}, isSide), 0.0) << pattern;
}

TEST(OcclusionTable, DifferencesOfTwoFacesAreEqualAtTheEdgeBetweenThem)
{
    const osg::ref_ptr<osg::Image> table = createOcclusionTable(1.2, RADIUS);
    const auto mirror = [](int pattern)
    {
        int mirrored = 0;
        for (int z = 0; z < 3; ++z)
            for (int y = 0; y < 2; ++y)
                for (int x = 0; x < 2; ++x)
                    if (x + y + z > 0 && (pattern >> bitAt({x, y, z}) & 1) != 0 && (x != 1 || y + z > 0))
                        mirrored |= 1 << bitAt({1 - x, y, z});
        return mirrored;
    };
    for (const bool isSide : {false, true})
        for (int pattern = 0; pattern < 2048; ++pattern)
        {
            // The cell beside the first face is open, and a wall is beside both or none: otherwise they are
            // interpolated at different places.
            if ((pattern & 7) != 0 && (pattern & 7) != 6) continue;
            for (int y = 4; y < 8; ++y)
                // The point is just inside one of the faces, and overhangs begin abruptly.
                ASSERT_NEAR(readDifference(*table, pattern, {7, y}, isSide),
                            readDifference(*table, mirror(pattern), {7, y}, isSide), 0.012)
                    << pattern << " at " << y;
        }
}

TEST(OcclusionTable, NothingHidesAnOpenQuadrant)
{
    const osg::ref_ptr<osg::Image> table = createOcclusionTable(1.2, RADIUS);
    for (const bool isSide : {false, true})
        for (int place = 0; place < 64; ++place)
        {
            const glm::dvec4 entry = readEntry(*table, 0, {place % 8, place / 8}, isSide);
            EXPECT_EQ(entry.x, 0.25);
            EXPECT_NEAR(entry.y, 1.0 / (3.0 * std::numbers::pi), 0.001);
            EXPECT_NEAR(entry.z, 1.0 / (3.0 * std::numbers::pi), 0.001);
            EXPECT_NEAR(entry.w, 1.0 / 6.0, 0.001);
        }
}

TEST(OcclusionTable, AnEdgeBetweenTwoNeighboursSeesAsMuchOfBoth)
{
    const osg::ref_ptr<osg::Image> table = createOcclusionTable(1.0, RADIUS);
    const glm::dvec4 first = readEntry(*table, 1, {7, 7}, false);
    const glm::dvec4 second = readEntry(*table, 2, {7, 7}, false);
    EXPECT_NEAR(first.x, 0.125, 0.002);
    EXPECT_NEAR(second.x, 0.125, 0.002);
    EXPECT_NEAR(first.y, second.z, 0.002);
}

} // namespace

} // namespace osgLego::test
