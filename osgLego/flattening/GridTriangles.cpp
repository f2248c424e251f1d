#include <osgLego/flattening/GridTriangles.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/packing.hpp>

namespace osgLego
{

namespace
{

using Corners = std::array<GridVertex, 3>;

std::array<float, 3> edgeLengths(const GridVertex* corners)
{
    return {glm::distance(corners[0].position, corners[1].position),
            glm::distance(corners[1].position, corners[2].position),
            glm::distance(corners[2].position, corners[0].position)};
}

glm::vec3 toCellPosition(const BrickGrid& grid, const glm::dvec3& position)
{
    const glm::vec3 cells(grid.toCells(osg::Vec3d(position.x, position.y, position.z)));
    glm::vec3 result;
    for (int axis = 0; axis < 3; ++axis)
    {
        const float end = std::nextafter(static_cast<float>(grid.dimensions[axis]), 0.0f);
        result[axis] = std::clamp(cells[axis], 0.0f, end);
    }
    return result;
}

/** The number of texels across the width of a cell, in the direction in which the texture is compressed most; 0 for a
 * triangle without area. */
double texelsPerCell(const Corners& corners, const glm::ivec2& textureSize)
{
    const glm::dvec3 edge1 = corners[1].position - corners[0].position;
    const glm::dvec3 edge2 = corners[2].position - corners[0].position;
    const glm::dvec2 size(textureSize);
    const glm::dvec2 texels1 = glm::dvec2(corners[1].coordinate - corners[0].coordinate) * size;
    const glm::dvec2 texels2 = glm::dvec2(corners[2].coordinate - corners[0].coordinate) * size;

    // In an orthonormal basis of the triangle's plane, a 2x2 matrix maps positions to texels. The result is its larger
    // singular value.
    const double length1 = glm::length(edge1);
    if (!(length1 > 0.0)) return 0.0;
    const glm::dvec3 axis1 = edge1 / length1;
    const double along = glm::dot(edge2, axis1);
    const double across = glm::length(edge2 - along * axis1);
    if (!(across > 0.0)) return 0.0;
    const glm::dvec2 column1 = texels1 / length1;
    const glm::dvec2 column2 = (texels2 - along * column1) / across;

    const double trace = glm::dot(column1, column1) + glm::dot(column2, column2);
    const double determinant = column1.x * column2.y - column1.y * column2.x;
    const double root = std::sqrt(std::max(0.0, trace * trace - 4.0 * determinant * determinant));
    return std::sqrt(0.5 * (trace + root));
}

/** The mipmap level at which a cell is two texels wide: linear filtering then covers the width of one cell. */
double textureLevel(const Corners& corners, const SurfaceTexture* texture)
{
    if (!texture) return 0.0;
    const double texels = texelsPerCell(corners, texture->getSize());
    return texels > 2.0 ? std::min(std::log2(0.5 * texels), PassConstants::MAXIMUM_LEVEL) : 0.0;
}

Corners toGrid(const BrickGrid& grid, const SceneVertex* vertices, const SurfaceTexture* texture,
               std::uint32_t triangle)
{
    Corners corners;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
        corners[corner].position = toCellPosition(grid, vertices[corner].position);
        corners[corner].coordinate = vertices[corner].coordinate;
        corners[corner].triangle = triangle;
    }
    const auto level = static_cast<float>(textureLevel(corners, texture) / PassConstants::MAXIMUM_LEVEL);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
        const glm::vec3& color = vertices[corner].color;
        corners[corner].colorAndLevel = {glm::packUnorm2x16({color.r, color.g}), glm::packUnorm2x16({color.b, level})};
    }
    return corners;
}

void appendBatches(const BrickGrid& grid, const SceneBatch& source, std::vector<GridBatch>& batches)
{
    const std::size_t total = source.vertices.size() / 3;
    for (std::size_t first = 0; first < total; first += GridBatch::MAXIMUM_TRIANGLES)
    {
        const std::size_t count = std::min(total - first, GridBatch::MAXIMUM_TRIANGLES);
        GridBatch batch{source.texture, source.environment, {}, 0.0f};
        batch.vertices.reserve(3 * count);
        for (std::size_t triangle = 0; triangle < count; ++triangle)
        {
            const Corners corners = toGrid(grid, &source.vertices[3 * (first + triangle)], source.texture.get(),
                                           static_cast<std::uint32_t>(triangle));
            batch.vertices.insert(batch.vertices.end(), corners.begin(), corners.end());
            for (const float length : edgeLengths(corners.data()))
                batch.longestEdge = std::max(batch.longestEdge, length);
        }
        batches.push_back(std::move(batch));
    }
}

/** The smallest power of two that divides a length down to the limit. */
double halvings(double length, double limit)
{
    return length > limit ? std::exp2(std::ceil(std::log2(length / limit))) : 1.0;
}

/** The number of unit cells that a triangle meets, on average over all positions: the volume of its Minkowski sum with
 * a cell. */
double meanCellsMet(const GridVertex* corners)
{
    const glm::dvec3 a(corners[0].position);
    const glm::dvec3 b(corners[1].position);
    const glm::dvec3 c(corners[2].position);
    const glm::dvec3 projectedAreas = 0.5 * glm::abs(glm::cross(b - a, c - a));
    const glm::dvec3 extent = glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c));
    return projectedAreas.x + projectedAreas.y + projectedAreas.z + extent.x + extent.y + extent.z + 1.0;
}

} // namespace

std::size_t GridBatch::estimateFineTriangles(double edgeLimit) const
{
    double sum = 0.0;
    for (std::size_t first = 0; first < vertices.size(); first += 3)
    {
        const std::array<float, 3> lengths = edgeLengths(&vertices[first]);
        const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
        // A sliver is only cut along its length, a well-shaped triangle also along its height.
        sum += halvings(*longest, edgeLimit) * halvings(*shortest, edgeLimit);
    }
    return static_cast<std::size_t>(sum);
}

osg::ref_ptr<const GridTriangles> GridTriangles::create(const SceneTriangles& triangles, const LegoSettings& settings)
{
    osg::ref_ptr<GridTriangles> result = new GridTriangles;
    result->_grid = BrickGrid::fit(triangles.getBounds(), settings);
    if (result->_grid.getNumCells() == 0) return result;
    for (const SceneBatch& batch : triangles.getBatches())
        appendBatches(result->_grid, batch, result->_batches);
    return result;
}

std::size_t GridTriangles::getNumTriangles() const
{
    std::size_t sum = 0;
    for (const GridBatch& batch : _batches)
        sum += batch.getNumTriangles();
    return sum;
}

float GridTriangles::getLongestEdge() const
{
    float longest = 0.0f;
    for (const GridBatch& batch : _batches)
        longest = std::max(longest, batch.longestEdge);
    return longest;
}

std::size_t GridTriangles::estimateCoveredCells() const
{
    double sum = 0.0;
    for (const GridBatch& batch : _batches)
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
            sum += meanCellsMet(&batch.vertices[first]);
    return static_cast<std::size_t>(std::min(sum, static_cast<double>(_grid.getNumCells())));
}

} // namespace osgLego
