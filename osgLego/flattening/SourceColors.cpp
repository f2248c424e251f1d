#include <osgLego/flattening/SourceColors.h>

#include <osgLego/flattening/OpenBlocks.h>
#include <osgLego/flattening/SubdivisionPattern.h>
#include <osgLego/flattening/SurfaceColor.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

using Corners = std::array<GridVertex, 3>;

/** A point of the surface. */
struct SurfacePoint
{
    glm::vec3 place{0.0f}; // in cells of the grid
    std::array<std::uint8_t, 3> color{};
};

double areaOf(const Corners& corners)
{
    const glm::dvec3 a(corners[0].position);
    return 0.5 * glm::length(glm::cross(glm::dvec3(corners[1].position) - a, glm::dvec3(corners[2].position) - a)) +
           PassConstants::LEAST_WEIGHT;
}

/** Barycentric coordinates of points that are spread evenly, in any order of triangles (Roberts 2018, the sequence R2).
 */
glm::dvec3 sharesAt(std::size_t number)
{
    const auto fraction = [&](double factor)
    {
        const double value = factor * static_cast<double>(number);
        return value - std::floor(value);
    };
    glm::dvec2 point(fraction(0.7548776662466927), fraction(0.5698402909980532));
    // The other half of the square is the triangle turned.
    if (point.x + point.y > 1.0) point = 1.0 - point;
    return {1.0 - point.x - point.y, point.x, point.y};
}

/** Picks points of the surface inside the grid. */
class PointPicker
{
public:
    explicit PointPicker(const GridTriangles& triangles) :
        _triangles(triangles), _minimum(triangles.getFirstCell()),
        _maximum(triangles.getFirstCell() + triangles.getGrid().dimensions)
    {
    }

    std::vector<SurfacePoint> pick()
    {
        constexpr double NUM_POINTS = 65536.0;
        double sum = 0.0;
        forEachPart([&](const GridBatch&, const Corners& corners) { sum += areaOf(corners); });
        const double step = sum / NUM_POINTS;
        double next = 0.5 * step;
        sum = 0.0;
        std::size_t number = 0;
        forEachPart(
            [&](const GridBatch& batch, const Corners& corners)
            {
                for (sum += areaOf(corners); next < sum; next += step)
                    add(batch, corners, sharesAt(number++));
            });
        return std::move(_points);
    }

private:
    /** Call a function for each triangle, or for the parts of a triangle near the grid that reaches out of it. */
    template <typename Use>
    void forEachPart(const Use& use) const
    {
        constexpr float SMALLEST = 1.0f / 16.0f; // of the grid's longest side
        const glm::vec3 size = _maximum - _minimum;
        const float limit = std::max(SMALLEST * std::max(size.x, std::max(size.y, size.z)), 1.0f);
        for (const GridBatch& batch : _triangles.getBatches())
            for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
                cutToSize(
                    Corners{batch.vertices[first], batch.vertices[first + 1], batch.vertices[first + 2]}, limit * limit,
                    [&](const Corners& part) { return decide(part); }, [&](const Corners& part) { use(batch, part); });
    }

    PartUse decide(const Corners& corners) const
    {
        const auto [a, b, c] = std::tie(corners[0].position, corners[1].position, corners[2].position);
        const glm::vec3 low = glm::min(a, glm::min(b, c));
        const glm::vec3 high = glm::max(a, glm::max(b, c));
        if (glm::any(glm::lessThan(high, _minimum)) || glm::any(glm::greaterThan(low, _maximum)))
            return PartUse::DROPPED;
        const bool isInside =
            glm::all(glm::greaterThanEqual(low, _minimum)) && glm::all(glm::lessThanEqual(high, _maximum));
        return isInside ? PartUse::KEPT : PartUse::CUT;
    }

    void add(const GridBatch& batch, const Corners& corners, const glm::dvec3& shares)
    {
        glm::dvec3 place(0.0);
        glm::dvec3 color(0.0);
        for (int corner = 0; corner < 3; ++corner)
        {
            place += shares[corner] * glm::dvec3(corners[static_cast<std::size_t>(corner)].position);
            color += shares[corner] * glm::dvec3(corners[static_cast<std::size_t>(corner)].getColor());
        }
        const glm::vec3 position(place);
        if (glm::any(glm::lessThan(position, _minimum)) || glm::any(glm::greaterThan(position, _maximum))) return;
        const glm::vec3 levels =
            255.0f * glm::clamp(applyTexture(batch, corners.data(), shares, glm::vec3(color)), 0.0f, 1.0f) + 0.5f;
        _points.push_back({position - _minimum,
                           {static_cast<std::uint8_t>(levels.r), static_cast<std::uint8_t>(levels.g),
                            static_cast<std::uint8_t>(levels.b)}});
    }

    const GridTriangles& _triangles;
    glm::vec3 _minimum;
    glm::vec3 _maximum;
    std::vector<SurfacePoint> _points;
};

} // namespace

ColorHistogram histogramOf(const GridTriangles& triangles)
{
    const std::vector<SurfacePoint> points = PointPicker(triangles).pick();
    OpenBlocks blocks(triangles.getGrid().dimensions);
    for (const SurfacePoint& point : points)
        blocks.cover(point.place);
    blocks.findOpen();
    ColorHistogram histogram;
    for (const SurfacePoint& point : points)
        if (blocks.isBesideOpen(point.place)) histogram.add(point.color, 1.0);
    return histogram;
}

} // namespace osgLego
