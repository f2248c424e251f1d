#include <osgLego/CpuLegolizer.h>

#include <osgLego/TriangleOverlap.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <osg/Notify>

namespace osgLego
{

namespace
{

// In cells squared: lets a triangle that only grazes a cell decide its colour when no other covers it.
constexpr double LEAST_WEIGHT = 1e-9;

/** What one triangle says of the colour of one cell. */
struct Contribution
{
    std::uint32_t cell; // its number in the grid
    float weight;
    glm::vec3 color;
};

glm::dvec3 joined(const glm::dvec3& color, const glm::dvec4& texel, TextureEnvironment environment)
{
    const glm::dvec3 texture(texel);
    switch (environment)
    {
    case TextureEnvironment::REPLACE:
        return texture;
    case TextureEnvironment::DECAL:
        return glm::mix(color, texture, texel.a);
    case TextureEnvironment::ADD:
        return glm::min(color + texture, 1.0);
    case TextureEnvironment::MODULATE:
        break;
    }
    return color * texture;
}

/** The surface colour at a point of a triangle. @param weights its barycentric coordinates. */
glm::dvec3 colorAt(const GridBatch& batch, const GridVertex* corners, const glm::dvec3& weights)
{
    glm::dvec3 color(0.0);
    glm::dvec2 coordinate(0.0);
    for (int corner = 0; corner < 3; ++corner)
    {
        color += weights[corner] * corners[corner].getColor();
        coordinate += weights[corner] * glm::dvec2(corners[corner].coordinate);
    }
    if (!batch.texture) return color;
    return joined(color, batch.texture->sample(coordinate, corners[0].getLevel()), batch.environment);
}

void addContributions(const GridBatch& batch, const glm::ivec3& dimensions, std::vector<Contribution>& contributions)
{
    std::vector<glm::ivec3> cells;
    for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
    {
        const GridVertex* corners = &batch.vertices[first];
        const TriangleOverlap overlap(corners[0].position, corners[1].position, corners[2].position);
        cells.clear();
        overlap.findCells(dimensions, cells);
        for (const glm::ivec3& cell : cells)
        {
            const glm::dvec3 nearest = overlap.findNearest(glm::dvec3(cell) + 0.5);
            const auto row = static_cast<std::uint32_t>(cell.y) +
                             static_cast<std::uint32_t>(dimensions.y) * static_cast<std::uint32_t>(cell.z);
            contributions.push_back(
                {static_cast<std::uint32_t>(cell.x) + static_cast<std::uint32_t>(dimensions.x) * row,
                 static_cast<float>(overlap.getAreaInside(cell) + LEAST_WEIGHT),
                 glm::vec3(colorAt(batch, corners, nearest))});
        }
    }
}

glm::ivec3 cellOf(std::uint32_t number, const glm::ivec3& dimensions)
{
    const auto width = static_cast<std::uint32_t>(dimensions.x);
    const auto depth = static_cast<std::uint32_t>(dimensions.y);
    return {number % width, number / width % depth, number / width / depth};
}

Brick makeBrick(const glm::ivec3& cell, const glm::dvec3& color)
{
    Brick brick;
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto index = static_cast<std::size_t>(axis);
        brick.cell[index] = static_cast<std::uint16_t>(cell[axis]);
        brick.color[index] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(color[axis], 0.0, 1.0)));
    }
    return brick;
}

std::vector<Brick> averaged(const std::vector<Contribution>& contributions, const glm::ivec3& dimensions)
{
    std::vector<Brick> bricks;
    for (auto first = contributions.begin(); first != contributions.end();)
    {
        glm::dvec3 color(0.0);
        double weight = 0.0;
        auto next = first;
        for (; next != contributions.end() && next->cell == first->cell; ++next)
        {
            color += static_cast<double>(next->weight) * glm::dvec3(next->color);
            weight += static_cast<double>(next->weight);
        }
        bricks.push_back(makeBrick(cellOf(first->cell, dimensions), color / weight));
        first = next;
    }
    return bricks;
}

} // namespace

osg::ref_ptr<const BrickModel> legolizeOnCpu(const osg::Node& node, const LegoSettings& settings)
{
    if (const std::string error = settings.check(); !error.empty())
    {
        OSG_WARN << "osgLego: " << error << std::endl;
        return nullptr;
    }
    const osg::ref_ptr<const SceneTriangles> scene = SceneTriangles::create(node);
    if (scene->getNumTriangles() == 0)
    {
        OSG_WARN << "osgLego: '" << node.getName() << "' shows no triangles to legolize" << std::endl;
        return nullptr;
    }
    return legolizeOnCpu(*GridTriangles::create(*scene, settings));
}

osg::ref_ptr<const BrickModel> legolizeOnCpu(const GridTriangles& triangles)
{
    const BrickGrid& grid = triangles.getGrid();
    std::vector<Contribution> contributions;
    for (const GridBatch& batch : triangles.getBatches())
        addContributions(batch, grid.dimensions, contributions);
    // Stable, so that the sums are taken in the order of the triangles, and come out the same on every run.
    std::stable_sort(contributions.begin(), contributions.end(),
                     [](const Contribution& a, const Contribution& b) { return a.cell < b.cell; });
    return BrickModel::create(grid, averaged(contributions, grid.dimensions));
}

} // namespace osgLego
