#include <osgLego/cpu/NearestPoint.h>

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Corners = std::array<glm::vec3, 3>;

class NearestPointTest : public ::testing::Test
{
protected:
    glm::vec3 place(float size)
    {
        std::uniform_real_distribution<float> anywhere(-size, size);
        return {anywhere(_generator), anywhere(_generator), anywhere(_generator)};
    }

    /** Test four points around a triangle. The point found must lie in the triangle; and it is the nearest point of a
     * convex set if no corner of the set lies further towards the given point. */
    void expectNearest(const Corners& corners, float size)
    {
        std::array<glm::dvec3, NearestPoint::NUM_LANES> points;
        for (glm::dvec3& point : points)
            point = glm::dvec3(corners[0] + place(size));
        const auto lanesOf = [&points](int axis)
        { return NearestPoint::Lanes([&](std::size_t lane) { return points[lane][axis]; }); };
        const NearestPoint::Shares shares = NearestPoint(corners).find(lanesOf(0), lanesOf(1), lanesOf(2));
        for (std::size_t lane = 0; lane < points.size(); ++lane)
        {
            const double b = shares.b[lane];
            const double c = shares.c[lane];
            EXPECT_GE(std::min(b, c), 0.0);
            EXPECT_LE(b + c, 1.0 + 1e-12);
            const glm::dvec3 found =
                (1.0 - b - c) * glm::dvec3(corners[0]) + b * glm::dvec3(corners[1]) + c * glm::dvec3(corners[2]);
            const glm::dvec3 towards = points[lane] - found;
            for (const glm::vec3& corner : corners)
                EXPECT_LE(glm::dot(towards, glm::dvec3(corner) - found), 1e-6 * (1.0 + size * size));
        }
    }

    std::mt19937 _generator{5};
};

TEST_F(NearestPointTest, NoCornerLiesFurtherTowardsThePoint)
{
    for (const float size : {0.5f, 5.0f, 300.0f})
        for (int number = 0; number < 2000; ++number)
        {
            const glm::vec3 first = place(500.0f);
            expectNearest({first, first + place(size), first + place(size)}, 2.0f * size);
        }
}

TEST_F(NearestPointTest, SliversAndPointsHaveNearestPointsToo)
{
    for (int number = 0; number < 1000; ++number)
    {
        const glm::vec3 first = place(20.0f);
        const glm::vec3 second = first + place(9.0f);
        expectNearest({first, second, 0.5f * (first + second)}, 9.0f);
        expectNearest({first, second, second}, 9.0f);
        expectNearest({first, first, second}, 9.0f);
        expectNearest({first, first, first}, 9.0f);
    }
}

} // namespace

} // namespace osgLego
