#include <osgLego/polygonization/StudVisibility.h>

#include <cmath>
#include <numbers>
#include <random>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using BrickDimensions::isStudSeen;
using BrickDimensions::STUD_RADIUS;

constexpr double HEIGHT = 0.2;

/** Whether the line from a point of a stud to the eye, relative to the centre of the stud's foot, misses its brick. */
bool goesPastBrick(const glm::dvec3& point, const glm::dvec3& toEye)
{
    const glm::dvec3 crossing = point - point.z / toEye.z * toEye;
    return std::max(std::abs(crossing.x), std::abs(crossing.y)) > 0.5;
}

/** Whether the rim of the stud is visible; from below, it is the last part of the stud to disappear. */
bool isRimSeen(const glm::dvec3& eye, double eyeWeight)
{
    for (int step = 0; step < 64; ++step)
    {
        const double angle = 2.0 * std::numbers::pi * step / 64;
        const glm::dvec3 point(STUD_RADIUS * std::cos(angle), STUD_RADIUS * std::sin(angle), HEIGHT);
        if (goesPastBrick(point, eye - eyeWeight * point)) return true;
    }
    return false;
}

TEST(StudVisibility, AStudOfWhichAnythingIsSeenIsSeen)
{
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> place(-20.0, 20.0);
    std::uniform_real_distribution<double> depth(-10.0, -0.01);
    int numSeen = 0;
    for (int repeat = 0; repeat < 20000; ++repeat)
    {
        const glm::dvec3 eye(place(engine), place(engine), depth(engine));
        for (const double eyeWeight : {0.0, 1.0})
        {
            if (!isRimSeen(eye, eyeWeight)) continue;
            ++numSeen;
            ASSERT_TRUE(isStudSeen(std::hypot(eye.x, eye.y), -eye.z, HEIGHT, eyeWeight))
                << eye.x << " " << eye.y << " " << eye.z << " " << eyeWeight;
        }
    }
    EXPECT_GT(numSeen, 5000);
}

TEST(StudVisibility, AStudFarAboveTheEyeIsNotSeen)
{
    for (const double eyeWeight : {0.0, 1.0})
    {
        EXPECT_FALSE(isStudSeen(0.0, 10.0, HEIGHT, eyeWeight));
        EXPECT_FALSE(isStudSeen(9.0, 10.0, HEIGHT, eyeWeight));
        EXPECT_TRUE(isStudSeen(11.0, 10.0, HEIGHT, eyeWeight));
    }
}

} // namespace

} // namespace osgLego
