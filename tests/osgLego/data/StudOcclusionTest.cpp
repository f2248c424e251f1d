#include <osgLego/BrickDimensions.h>
#include <osgLego/data/OcclusionFalloff.h>
#include <osgLego/data/StudOcclusion.h>

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double REACH = 2.5;

/** The light that a stud hides from a point whose normal is the first axis, by random rays in small steps: its fraction
 * and its vector. Rays that meet the level of the stud before its brick ends do not count. */
glm::dvec4 findHidden(const glm::dvec3& point, const glm::dvec2& stud)
{
    constexpr int NUM_RAYS = 24000;
    constexpr double STEP = 0.02;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    glm::dvec4 sum(0.0);
    for (int ray = 0; ray < NUM_RAYS; ++ray)
    {
        const double square = uniform(random);
        const double angle = 2.0 * std::numbers::pi * uniform(random);
        const glm::dvec3 direction(std::sqrt(1.0 - square), std::sqrt(square) * std::cos(angle),
                                   std::sqrt(square) * std::sin(angle));
        double found = 0.0;
        for (double distance = 0.5 * STEP; distance < REACH && found == 0.0; distance += STEP)
        {
            const glm::dvec3 place = point + distance * direction;
            const bool isInside = glm::distance(glm::dvec2(place), stud) < BrickDimensions::STUD_RADIUS &&
                                  place.z > 0.0 && place.z < BrickDimensions::STUD_HEIGHT;
            if (isInside) found = distance;
        }
        if (found == 0.0) continue;
        const bool isBelow = direction.z < 0.0 && point.x - point.z / direction.z * direction.x < stud.x + 0.5;
        if (!isBelow) sum += fadeOcclusion(found, REACH) * glm::dvec4(1.0, direction.x, direction.y, direction.z);
    }
    return sum / static_cast<double>(NUM_RAYS);
}

void expectEntry(const osg::Image& table, int column, int line, const glm::dvec4& expected)
{
    const unsigned char* texel = table.data(static_cast<unsigned int>(column), static_cast<unsigned int>(line));
    EXPECT_NEAR(texel[0] / 510.0, expected.x, 0.008) << column << ' ' << line;
    EXPECT_NEAR(texel[1] / 510.0, expected.z, 0.008) << column << ' ' << line << ", along the surface";
    EXPECT_NEAR(texel[2] / 255.0 - 0.5, expected.w, 0.008) << column << ' ' << line << ", up";
    EXPECT_NEAR(texel[3] / 510.0, expected.y, 0.008) << column << ' ' << line << ", along the normal";
}

TEST(StudOcclusion, HasTheLightThatRaysFindAtTheFootOfASide)
{
    constexpr double HEIGHT = 1.2;
    const osg::ref_ptr<osg::Image> table = createStudOcclusion(HEIGHT, REACH);
    ASSERT_EQ(table->s(), 32);
    ASSERT_EQ(table->t(), 32);
    EXPECT_GT(findHidden({0.0, 0.0, 0.05}, {0.5, 0.0}).x, 0.15) << "there is nothing to compare";
    for (const int line : {0, 1, 3, 7})
        for (const int column : {0, 5, 12, 25})
            expectEntry(*table, column, line, findHidden({0.0, 0.0, HEIGHT * line / 7.0}, {0.5, 1.5 * column / 31.0}));
}

TEST(StudOcclusion, HasTheLightThatRaysFindOnTheWallOfAnotherStud)
{
    const osg::ref_ptr<osg::Image> table = createStudOcclusion(1.0, REACH);
    for (const bool isDiagonal : {false, true})
        for (const int line : {0, 3, 7})
            for (const int column : {0, 5, 12, 31})
            {
                const double cosine = 1.0 - 2.0 * column / 31.0;
                const double sine = std::sqrt(1.0 - cosine * cosine);
                const glm::dvec2 stud = (isDiagonal ? std::sqrt(2.0) : 1.0) * glm::dvec2(cosine, sine) -
                                        glm::dvec2(BrickDimensions::STUD_RADIUS, 0.0);
                expectEntry(*table, column, (isDiagonal ? 16 : 8) + line,
                            findHidden({0.0, 0.0, BrickDimensions::STUD_HEIGHT * line / 7.0}, stud));
            }
}

} // namespace

} // namespace osgLego::test
