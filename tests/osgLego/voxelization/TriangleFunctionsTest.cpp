#include <osgLego/cpu/NearestPoint.h>

#include <CellClipping.h>
#include <GlslFunctionTest.h>

#include <random>

#include <glm/geometric.hpp>

namespace osgLego::test
{

namespace
{

using Corners = std::array<glm::vec3, 3>;

class TriangleFunctions : public GlslFunctionTest
{
protected:
    float between(float lowest, float highest)
    {
        return std::uniform_real_distribution<float>(lowest, highest)(_engine);
    }

    glm::vec3 place(float lowest, float highest)
    {
        return {between(lowest, highest), between(lowest, highest), between(lowest, highest)};
    }

    /** Corners at multiples of a fraction of a cell, displaced by up to a distance. */
    Corners onLattice(float fraction, float distance)
    {
        Corners corners;
        for (glm::vec3& corner : corners)
            corner = glm::round(place(-2.0f, 3.0f) / fraction) * fraction + place(-distance, distance);
        return corners;
    }

    /** Compare the areas in the unit cell with the areas of the clipped polygons. */
    void expectAreas(const std::vector<Corners>& triangles)
    {
        std::vector<Arguments> arguments;
        std::vector<double> areas;
        for (Corners corners : triangles)
        {
            const Polygon polygon(corners.begin(), corners.end());
            areas.push_back(areaOf(clipByCell(polygon, glm::ivec3(0))));
            // As in the pass, the last axis is the one nearest to the normal.
            const glm::dvec3 normal = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
            const glm::dvec3 size = glm::abs(normal);
            const int last = size.z >= std::max(size.x, size.y) ? 2 : size.x >= size.y ? 0 : 1;
            for (glm::vec3& corner : corners)
                corner = {corner[(last + 1) % 3], corner[(last + 2) % 3], corner[last]};
            const double ratio = size[last] > 0.0 ? glm::length(normal) / size[last] : 0.0;
            arguments.push_back({glm::vec4(corners[0], 0.0f), glm::vec4(corners[1], 0.0f), glm::vec4(corners[2], 0.0f),
                                 glm::vec4(static_cast<float>(ratio))});
        }
        const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
        const std::vector<glm::vec4> results =
            evaluate("tests/area_in_cell.vert",
                     "#include \"voxelization/area_in_cell.glsl\"\n"
                     "void main() { result = vec4(areaInCell(a.xyz, b.xyz, c.xyz, d.x)); }\n",
                     arguments, *stateSet);
        for (std::size_t triangle = 0; triangle < areas.size(); ++triangle)
            ASSERT_NEAR(results[triangle].x, areas[triangle], 2e-6) << triangle;
    }

    std::mt19937 _engine{11};
};

TEST_F(TriangleFunctions, TheAreaInACellEqualsTheClippedTriangles)
{
    std::vector<Corners> triangles;
    for (const float size : {0.1f, 1.0f, 3.0f})
        for (int number = 0; number < 3000; ++number)
        {
            const glm::vec3 first = place(-0.5f, 1.5f);
            triangles.push_back({first, first + place(-size, size), first + place(-size, size)});
        }
    expectAreas(triangles);
}

TEST_F(TriangleFunctions, TheAreaInACellEqualsTheClippedTrianglesOnAndNearEdgesAndCorners)
{
    std::vector<Corners> triangles;
    for (const float fraction : {1.0f, 0.5f, 0.25f})
        for (const float distance : {0.0f, 1e-7f, 1e-5f, 1e-3f})
            for (int number = 0; number < 3000; ++number)
                triangles.push_back(onLattice(fraction, distance));
    expectAreas(triangles);
}

TEST_F(TriangleFunctions, TheNearestPointEqualsTheCpus)
{
    std::vector<Arguments> arguments;
    for (const float size : {0.3f, 1.0f, 8.0f})
        for (int number = 0; number < 3000; ++number)
        {
            const glm::vec3 first = place(-size, size);
            // Includes triangles without area, whose corners coincide.
            const glm::vec3 second = number % 10 == 0 ? first : first + place(-size, size);
            const glm::vec3 third = number % 15 == 0 ? second : second + place(-size, size);
            arguments.push_back({glm::vec4(first, 0.0f), glm::vec4(second, 0.0f), glm::vec4(third, 0.0f),
                                 glm::vec4(place(-2.0f * size, 2.0f * size), 0.0f)});
        }
    const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    const std::vector<glm::vec4> results =
        evaluate("tests/nearest_point.vert",
                 "#include \"voxelization/nearest_point.glsl\"\n"
                 "void main() { result = vec4(nearestPoint(d.xyz, a.xyz, b.xyz, c.xyz), 0.0); }\n",
                 arguments, *stateSet);

    for (std::size_t number = 0; number < arguments.size(); ++number)
    {
        const auto& [a, b, c, point] = arguments[number];
        const NearestPoint nearest({glm::vec3(a), glm::vec3(b), glm::vec3(c)});
        const NearestPoint::Shares shares =
            nearest.find(NearestPoint::Lanes(point.x), NearestPoint::Lanes(point.y), NearestPoint::Lanes(point.z));
        const auto placeOf = [&corners = arguments[number]](const glm::dvec3& weights)
        {
            return weights.x * glm::dvec3(corners[0]) + weights.y * glm::dvec3(corners[1]) +
                   weights.z * glm::dvec3(corners[2]);
        };
        const double shareB = shares.b[0];
        const double shareC = shares.c[0];
        const glm::dvec3 expected = placeOf({1.0 - shareB - shareC, shareB, shareC});
        ASSERT_LT(glm::distance(placeOf(glm::dvec3(results[number])), expected), 1e-3) << number;
    }
}

} // namespace

} // namespace osgLego::test
