#include <osgLego/subdivision/GridCut.h>

#include <osgLego/flattening/SubdivisionPattern.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

// In cells. Parts that reach no farther beyond the grid are left to the pass, which is faster.
constexpr float REACH = 8.0f;

using Corners = std::array<GridVertex, 3>;

/** The grid in the coordinates of positions, and the triangles' relation to it. */
class GridBox
{
public:
    explicit GridBox(const GridTriangles& triangles) :
        _begin(triangles.getFirstCell()), _end(_begin + glm::vec3(triangles.getGrid().dimensions))
    {
    }

    bool isNear(const glm::vec3& lowest, const glm::vec3& highest) const
    {
        return glm::all(glm::greaterThanEqual(lowest, _begin - REACH)) &&
               glm::all(glm::lessThanEqual(highest, _end + REACH));
    }

    PartUse decide(const Corners& corners) const
    {
        const auto& [a, b, c] = corners;
        const glm::vec3 lowest = glm::min(a.position, glm::min(b.position, c.position));
        const glm::vec3 highest = glm::max(a.position, glm::max(b.position, c.position));
        if (glm::any(glm::lessThan(highest, _begin)) || glm::any(glm::greaterThanEqual(lowest, _end)))
            return PartUse::DROPPED;
        return isNear(lowest, highest) ? PartUse::KEPT : PartUse::CUT;
    }

private:
    glm::vec3 _begin;
    glm::vec3 _end;
};

void append(const Corners& corners, GridBatch& batch)
{
    batch.vertices.insert(batch.vertices.end(), corners.begin(), corners.end());
    for (std::size_t edge = 0; edge < 3; ++edge)
        batch.longestEdge =
            std::max(batch.longestEdge, std::sqrt(squaredLength(corners[edge], corners[(edge + 1) % 3])));
}

} // namespace

std::optional<GridBatch> cutToGrid(const GridBatch& batch, const GridTriangles& triangles, double edgeLimit)
{
    const GridBox box(triangles);
    if (std::all_of(batch.vertices.begin(), batch.vertices.end(),
                    [&](const GridVertex& vertex) { return box.isNear(vertex.position, vertex.position); }))
        return std::nullopt;

    GridBatch parts{batch.texture, batch.environment, {}, 0.0f};
    const auto limit = static_cast<float>(edgeLimit);
    for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
        cutToSize(
            Corners{batch.vertices[first], batch.vertices[first + 1], batch.vertices[first + 2]}, limit * limit,
            [&](const Corners& part) { return box.decide(part); }, [&](const Corners& part) { append(part, parts); });
    return parts;
}

} // namespace osgLego
