#include <osgLego/flattening/GridTriangles.h>

#include <osgLego/data/SharedObjects.h>
#include <osgLego/flattening/GridFrame.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

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

/** The mipmap level at which a cell is two texels wide: linear filtering then covers the width of one cell. Negative
 * where a cell is less than two texels wide. */
double textureLevel(const Corners& corners, const SurfaceTexture* texture)
{
    if (!texture) return 0.0;
    const double texels = texelsPerCell(corners, texture->getSize());
    return texels > 0.0 ? std::log2(0.5 * texels) : PassConstants::MINIMUM_LEVEL;
}

/** Converts triangles, appends them to batches, and begins another batch when one is full. */
class BatchAppender
{
public:
    /** @param count the number of triangles expected. */
    BatchAppender(const GridFrame& frame, const SceneBatch& source, std::size_t count,
                  std::vector<GridBatch>& batches) :
        _frame(frame),
        _source(source), _expected(count), _batches(batches)
    {
    }

    /** @param corners with positions in the frame. */
    void add(const GridFrame::Corners& corners)
    {
        if (_count++ % GridBatch::MAXIMUM_TRIANGLES == 0) begin();
        GridBatch& batch = _batches.back();
        const Corners converted = convert(corners, static_cast<std::uint32_t>(batch.getNumTriangles()));
        batch.vertices.insert(batch.vertices.end(), converted.begin(), converted.end());
        for (const float length : edgeLengths(converted.data()))
            batch.longestEdge = std::max(batch.longestEdge, length);
    }

private:
    void begin()
    {
        const std::size_t rest = _expected >= _count ? _expected - _count + 1 : 1;
        _batches.push_back({_source.texture, _source.environment, {}, 0.0f});
        _batches.back().vertices.reserve(3 * std::min(rest, GridBatch::MAXIMUM_TRIANGLES));
    }

    Corners convert(const GridFrame::Corners& corners, std::uint32_t triangle) const
    {
        Corners result;
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            result[corner].position = _frame.round(corners[corner].position);
            result[corner].coordinate = corners[corner].coordinate;
            result[corner].triangle = triangle;
        }
        const double level = textureLevel(result, _source.texture.get());
        for (std::size_t corner = 0; corner < 3; ++corner)
            result[corner].setColorAndLevel(corners[corner].color, level);
        return result;
    }

    const GridFrame& _frame;
    const SceneBatch& _source;
    std::size_t _expected;
    std::size_t _count = 0;
    std::vector<GridBatch>& _batches;
};

/** Halve a triangle that is too long for single precision at its longest edge, and its parts again, until they are
 * short enough. Cuts at all long edges, as in subdivision, would make a sliver of three long edges into as many parts
 * as the square of its length.
 *
 * Triangles beside each other may be cut at other places of their common edge. Rounding then moves it by at most a
 * thousandth of a cell. */
template <typename Keep>
void halveToFit(const GridFrame& frame, const GridFrame::Corners& corners, const Keep& keep)
{
    if (!frame.mayReachGrid(corners)) return;
    if (!frame.mustCut(corners))
    {
        keep(corners);
        return;
    }
    std::size_t longest = 0;
    const auto getLength = [&corners](std::size_t edge)
    { return squaredLength(corners[edge], corners[(edge + 1) % 3]); };
    for (const std::size_t edge : {std::size_t(1), std::size_t(2)})
        if (getLength(edge) > getLength(longest)) longest = edge;
    const SceneVertex& a = corners[longest];
    const SceneVertex& b = corners[(longest + 1) % 3];
    const SceneVertex& c = corners[(longest + 2) % 3];
    const SceneVertex middle = midpoint(a, b);
    halveToFit(frame, {a, middle, c}, keep);
    halveToFit(frame, {middle, b, c}, keep);
}

void appendBatches(const GridFrame& frame, const SceneBatch& source, std::vector<GridBatch>& batches)
{
    BatchAppender appender(frame, source, source.vertices.size() / 3, batches);
    for (std::size_t first = 0; first < source.vertices.size(); first += 3)
    {
        GridFrame::Corners corners{source.vertices[first], source.vertices[first + 1], source.vertices[first + 2]};
        for (SceneVertex& corner : corners)
            corner.position = frame.toFrame(corner.position);
        halveToFit(frame, corners, [&](const GridFrame::Corners& part) { appender.add(part); });
    }
}

/** The smallest power of two that divides a length down to the limit. */
double halvings(double length, double limit)
{
    return length > limit ? std::exp2(std::ceil(std::log2(length / limit))) : 1.0;
}

/** The number of cells that a triangle meets, on average over all positions: the volume of its Minkowski sum with a
 * cell. Its extent along each axis is limited to that of the grid. */
double meanCellsMet(const GridVertex* corners, const glm::ivec3& dimensions)
{
    const glm::dvec3 a(corners[0].position);
    const glm::dvec3 b(corners[1].position);
    const glm::dvec3 c(corners[2].position);
    const glm::dvec3 size(dimensions);
    const glm::dvec3 sides(size.y * size.z, size.z * size.x, size.x * size.y);
    const glm::dvec3 projectedAreas = glm::min(0.5 * glm::abs(glm::cross(b - a, c - a)), sides);
    const glm::dvec3 extent = glm::min(glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c)), size);
    return projectedAreas.x + projectedAreas.y + projectedAreas.z + extent.x + extent.y + extent.z + 1.0;
}

/** The vertices, which have no padding. */
std::string_view asBytes(const std::vector<GridVertex>& vertices)
{
    return {reinterpret_cast<const char*>(vertices.data()), vertices.size() * sizeof(GridVertex)};
}

} // namespace

GridVertex midpoint(const GridVertex& a, const GridVertex& b)
{
    GridVertex result;
    result.position = 0.5f * (a.position + b.position);
    result.triangle = a.triangle;
    result.coordinate = 0.5f * (a.coordinate + b.coordinate);
    for (std::size_t word = 0; word < result.colorAndLevel.size(); ++word)
        result.colorAndLevel[word] = glm::packUnorm2x16(
            0.5f * (glm::unpackUnorm2x16(a.colorAndLevel[word]) + glm::unpackUnorm2x16(b.colorAndLevel[word])));
    return result;
}

float squaredLength(const GridVertex& a, const GridVertex& b)
{
    const glm::vec3 edge = b.position - a.position;
    return glm::dot(edge, edge);
}

bool GridBatch::isEqualTo(const GridBatch& other) const
{
    return texture == other.texture && environment == other.environment && asBytes(vertices) == asBytes(other.vertices);
}

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
    const GridFrame frame(result->_grid, triangles.getBounds(), !settings.grid.cellPitch);
    result->_firstCell = frame.getFirstCell();
    // In advance, since a vector that grows copies batches: osg::ref_ptr has no move constructor that can't throw.
    std::size_t numBatches = 0;
    for (const SceneBatch& batch : triangles.getBatches())
        numBatches += batch.vertices.size() / 3 / GridBatch::MAXIMUM_TRIANGLES + 1;
    result->_batches.reserve(numBatches);
    for (const SceneBatch& batch : triangles.getBatches())
        appendBatches(frame, batch, result->_batches);
    return result;
}

osg::ref_ptr<const GridTriangles> GridTriangles::share(const GridTriangles& triangles)
{
    static SharedObjects<std::uint64_t, const GridTriangles> shared;
    osg::ref_ptr<const GridTriangles> found =
        shared.findOrCreate(triangles.computeHash(), [&] { return osg::ref_ptr<const GridTriangles>(&triangles); });
    return found->isEqualTo(triangles) ? found : osg::ref_ptr<const GridTriangles>(&triangles);
}

bool GridTriangles::isEqualTo(const GridTriangles& other) const
{
    return _grid == other._grid && _firstCell == other._firstCell &&
           std::ranges::equal(_batches, other._batches,
                              [](const GridBatch& a, const GridBatch& b) { return a.isEqualTo(b); });
}

std::uint64_t GridTriangles::computeHash() const
{
    std::uint64_t hash = 0;
    const auto add = [&hash](std::uint64_t other)
    {
        constexpr std::uint64_t FACTOR = 0x9e3779b97f4a7c15; // so that the order counts
        hash = FACTOR * hash + other;
    };
    for (int axis = 0; axis < 3; ++axis)
        add(std::hash<double>()(_grid.origin[axis]));
    for (const GridBatch& batch : _batches)
        add(std::hash<std::string_view>()(asBytes(batch.vertices)));
    return hash;
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
            sum += meanCellsMet(&batch.vertices[first], _grid.dimensions);
    return static_cast<std::size_t>(std::min(sum, static_cast<double>(_grid.getNumCells())));
}

} // namespace osgLego
