#include "FineTriangles.h"

#include <osgLego/flattening/SubdivisionPattern.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr float CUBE = 64.0f;

constexpr double TEXTURE_LEVEL = 4.0;

using Corners = std::array<GridVertex, 3>;

glm::vec2 coordinateAt(const glm::vec3& position)
{
    return {0.25f * position.x - 0.5f * position.y + 3.0f, 0.125f * position.z + 0.5f * position.x};
}

glm::vec3 colorAt(const glm::vec3& position)
{
    return {position.x / CUBE, 1.0f - position.y / CUBE, 0.5f * (position.z + position.x) / CUBE};
}

GridVertex createVertex(const glm::vec3& position, std::uint32_t triangle)
{
    GridVertex vertex{position, triangle, coordinateAt(position), {}};
    vertex.setColorAndLevel(colorAt(position), TEXTURE_LEVEL);
    return vertex;
}

/** Creates tetrahedra whose faces are counterclockwise, seen from outside or all from inside. */
class TetrahedronMaker
{
public:
    explicit TetrahedronMaker(std::uint32_t seed) : _engine(seed) {}

    void add(const std::array<glm::vec3, 4>& corners)
    {
        for (const std::array<std::size_t, 3>& face :
             {std::array<std::size_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
        {
            const auto triangle = static_cast<std::uint32_t>(vertices.size() / 3);
            for (const std::size_t corner : face)
                vertices.push_back(createVertex(corners[corner], triangle));
        }
    }

    /** @param kind 0 of any shape, 1 a long and thin one, 2 with coinciding corners, 3 with three corners in a line. */
    void addRandom(int kind)
    {
        const float size = 0.1f * std::pow(500.0f, fraction());
        const glm::vec3 first = (CUBE - size) * place();
        std::array<glm::vec3, 4> corners{first, first + size * place(), first + size * place(), first + size * place()};
        if (kind == 1)
        {
            corners[2] = 0.5f * (corners[0] + corners[1]) + 1e-3f * place();
            corners[3] = 0.75f * corners[0] + 0.25f * corners[1] + 1e-3f * place();
        }
        if (kind == 2) corners[1] = corners[0];
        if (kind == 3) corners[2] = 0.5f * (corners[0] + corners[1]);
        add(corners);
    }

    GridVertices vertices;

private:
    // Unlike the distributions of the standard library, this gives the same values everywhere.
    float fraction() { return static_cast<float>(_engine() >> 8) / 16777216.0f; }
    glm::vec3 place()
    {
        const float x = fraction();
        const float y = fraction();
        return {x, y, fraction()};
    }

    std::mt19937 _engine;
};

/** Twice the area of a triangle, as a vector along its normal. */
glm::dvec3 areaOf(const GridVertex* corners)
{
    const glm::dvec3 a(corners[0].position);
    return glm::cross(glm::dvec3(corners[1].position) - a, glm::dvec3(corners[2].position) - a);
}

double longestEdgeOf(const GridVertex* corners)
{
    double longest = 0.0;
    for (std::size_t edge = 0; edge < 3; ++edge)
        longest = std::max(
            longest, glm::distance(glm::dvec3(corners[edge].position), glm::dvec3(corners[(edge + 1) % 3].position)));
    return longest;
}

// In cells: all passes together move a corner by less than this through rounding.
constexpr double ROUNDING = 1e-4;

} // namespace

GridVertices createTetrahedra(std::uint32_t seed, int count, bool withDegenerateOnes)
{
    TetrahedronMaker maker(seed);
    maker.add({glm::vec3(0.0f), glm::vec3(2.0f, 0.0f, 0.0f), glm::vec3(0.0f, 2.0f, 0.0f), glm::vec3(0.0f, 0.0f, 2.0f)});
    for (int number = 0; number < count; ++number)
        maker.addRandom(number % (withDegenerateOnes ? 4 : 2));
    return maker.vertices;
}

FineTriangles subdivideOnCpu(const GridVertices& source, double edgeLimit)
{
    FineTriangles fine{source, 0};
    const auto limit = static_cast<float>(edgeLimit);
    for (bool isCut = true; isCut;)
    {
        isCut = false;
        GridVertices next;
        for (std::size_t first = 0; first < fine.vertices.size(); first += 3)
            isCut |= cutLongEdges(Corners{fine.vertices[first], fine.vertices[first + 1], fine.vertices[first + 2]},
                                  limit * limit,
                                  [&](const Corners& part) { next.insert(next.end(), part.begin(), part.end()); });
        fine.vertices.swap(next);
        if (isCut) ++fine.numPasses;
    }
    return fine;
}

std::size_t mostPasses(const GridVertices& source, double edgeLimit)
{
    double longest = 0.0;
    for (std::size_t first = 0; first < source.size(); first += 3)
        longest = std::max(longest, longestEdgeOf(&source[first]));
    if (longest <= edgeLimit) return 0;
    // A pass halves edges longer than the limit l. New edges are half as long as others or, where two of three edges
    // are cut, the shorter diagonal of a quadrilateral, which is the median of a triangle: at most
    // sqrt(L * L / 4 + l * l / 2), L being the longest edge before. So x = (L / l)^2 becomes at most x / 4 + 1 / 2, and
    // after k passes (x - 2 / 3) / 4^k + 2 / 3.
    const double ratio = longest * (1.0 + 1e-6) / edgeLimit;
    return static_cast<std::size_t>(std::ceil(0.5 * std::log2(3.0 * ratio * ratio - 2.0)));
}

void expectSameAreas(const GridVertices& source, const GridVertices& fine)
{
    std::vector<glm::dvec3> sums(source.size() / 3);
    for (std::size_t first = 0; first < fine.size(); first += 3)
        sums.at(fine[first].triangle) += areaOf(&fine[first]);
    for (std::size_t triangle = 0; triangle < sums.size(); ++triangle)
        ASSERT_LT(glm::distance(sums[triangle], areaOf(&source[3 * triangle])),
                  ROUNDING * (longestEdgeOf(&source[3 * triangle]) + ROUNDING))
            << triangle;
}

void expectSameNormals(const GridVertices& source, const GridVertices& fine)
{
    std::size_t compared = 0;
    for (std::size_t first = 0; first < fine.size(); first += 3)
    {
        const GridVertex* whole = &source.at(3 * fine[first].triangle);
        const glm::dvec3 wholeArea = areaOf(whole);
        const glm::dvec3 area = areaOf(&fine[first]);
        // The normal of a triangle that is hardly higher than the rounding error is not determined.
        if (glm::length(area) < 1e3 * ROUNDING * longestEdgeOf(&fine[first]) || glm::length(wholeArea) == 0.0) continue;
        ++compared;
        ASSERT_GT(glm::dot(glm::normalize(area), glm::normalize(wholeArea)), 0.999) << first;
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            const glm::dvec3 offset(fine[first + corner].position - whole[0].position);
            ASSERT_LT(std::abs(glm::dot(offset, glm::normalize(wholeArea))), ROUNDING) << first;
        }
    }
    EXPECT_GT(compared, fine.size() / 10) << "too few normals are determined";
}

void expectNoCracks(const GridVertices& triangles)
{
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, int> balance;
    const auto placeOf = [](const GridVertex& vertex) {
        return Place{vertex.position.x, vertex.position.y, vertex.position.z};
    };
    for (std::size_t first = 0; first < triangles.size(); first += 3)
        for (std::size_t edge = 0; edge < 3; ++edge)
        {
            const Place from = placeOf(triangles[first + edge]);
            const Place to = placeOf(triangles[first + (edge + 1) % 3]);
            if (from < to) ++balance[{from, to}];
            if (to < from) --balance[{to, from}];
        }
    EXPECT_EQ(std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }), 0)
        << "of " << balance.size() << " edges";
}

void expectShortEdges(const GridVertices& triangles, double edgeLimit)
{
    for (std::size_t first = 0; first < triangles.size(); first += 3)
        ASSERT_LE(longestEdgeOf(&triangles[first]), edgeLimit * (1.0 + 1e-6)) << first;
}

void expectLinearAttributes(const GridVertices& triangles, double colorTolerance)
{
    for (const GridVertex& vertex : triangles)
    {
        ASSERT_LT(glm::distance(vertex.coordinate, coordinateAt(vertex.position)), 1e-4f);
        ASSERT_LT(glm::distance(glm::dvec3(vertex.getColor()), glm::dvec3(colorAt(vertex.position))), colorTolerance);
        ASSERT_NEAR(vertex.getLevel(), TEXTURE_LEVEL, 1e-3);
    }
}

} // namespace osgLego::test
