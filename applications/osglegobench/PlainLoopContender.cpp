#include "PlainLoopContender.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

/** Whether an axis separates the triangle, given relative to the box's centre, from the box. */
bool isApart(const std::array<glm::vec3, 3>& triangle, const glm::vec3& halfSize, const glm::vec3& axis)
{
    const float a = glm::dot(axis, triangle[0]);
    const float b = glm::dot(axis, triangle[1]);
    const float c = glm::dot(axis, triangle[2]);
    const float radius = glm::dot(halfSize, glm::abs(axis));
    return std::min({a, b, c}) > radius || std::max({a, b, c}) < -radius;
}

/** Whether a triangle and a box have a point in common, according to Akenine-Moller, Fast 3D Triangle-Box Overlap
 * Testing, 2001: tests thirteen axes in single precision, for a box closed on all sides. Independent of
 * TriangleOverlap. */
bool overlapsBox(const std::array<glm::vec3, 3>& triangle, const glm::vec3& center, const glm::vec3& halfSize)
{
    const std::array<glm::vec3, 3> moved{triangle[0] - center, triangle[1] - center, triangle[2] - center};
    const std::array<glm::vec3, 3> edges{moved[1] - moved[0], moved[2] - moved[1], moved[0] - moved[2]};
    for (const glm::vec3& edge : edges)
    {
        if (isApart(moved, halfSize, {0.0f, -edge.z, edge.y})) return false;
        if (isApart(moved, halfSize, {edge.z, 0.0f, -edge.x})) return false;
        if (isApart(moved, halfSize, {-edge.y, edge.x, 0.0f})) return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto [minimum, maximum] = std::minmax({moved[0][axis], moved[1][axis], moved[2][axis]});
        if (minimum > halfSize[axis] || maximum < -halfSize[axis]) return false;
    }
    return !isApart({moved[0], moved[0], moved[0]}, halfSize, glm::cross(edges[0], edges[1]));
}

} // namespace

std::string PlainLoopContender::prepare(const BenchMesh& mesh, osg::GraphicsContext& context)
{
    _dimensions = mesh.triangles->getGrid().dimensions;
    _cells.resize(mesh.triangles->getGrid().getNumCells());
    return NativeContender::prepare(mesh, context);
}

osg::ref_ptr<const BrickModel> PlainLoopContender::findCells()
{
    std::fill(_cells.begin(), _cells.end(), std::uint8_t(0));
    for (const GridBatch& batch : getTriangles().getBatches())
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
            cover(&batch.vertices[first]);
    return nullptr;
}

std::size_t PlainLoopContender::numberOf(const glm::ivec3& cell) const
{
    const auto row =
        static_cast<std::size_t>(cell.y) + static_cast<std::size_t>(_dimensions.y) * static_cast<std::size_t>(cell.z);
    return static_cast<std::size_t>(cell.x) + static_cast<std::size_t>(_dimensions.x) * row;
}

void PlainLoopContender::cover(const GridVertex* corners)
{
    const std::array<glm::vec3, 3> triangle{corners[0].position, corners[1].position, corners[2].position};
    const glm::ivec3 first(glm::min(triangle[0], glm::min(triangle[1], triangle[2])));
    const glm::ivec3 last(glm::max(triangle[0], glm::max(triangle[1], triangle[2])));
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x)
                if (overlapsBox(triangle, glm::vec3(x, y, z) + 0.5f, glm::vec3(0.5f))) _cells[numberOf({x, y, z})] = 1;
}

std::uint8_t PlainLoopContender::findOpenSides(const glm::ivec3& cell) const
{
    unsigned int sides = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
        glm::ivec3 step(0);
        step[axis] = 1;
        const auto bit = 2 * static_cast<unsigned int>(axis); // of the lower side on this axis, such as SIDE_LEFT
        if (cell[axis] == 0 || _cells[numberOf(cell - step)] == 0) sides |= 1u << bit;
        if (cell[axis] + 1 == _dimensions[axis] || _cells[numberOf(cell + step)] == 0) sides |= 2u << bit;
    }
    return static_cast<std::uint8_t>(sides);
}

template <typename Function>
void PlainLoopContender::visitBricks(const Function& function) const
{
    std::size_t number = 0;
    glm::ivec3 cell;
    for (cell.z = 0; cell.z < _dimensions.z; ++cell.z)
        for (cell.y = 0; cell.y < _dimensions.y; ++cell.y)
            for (cell.x = 0; cell.x < _dimensions.x; ++cell.x)
                if (_cells[number++] != 0)
                    function(Brick{{static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y),
                                    static_cast<std::uint16_t>(cell.z)},
                                   {160, 160, 160},
                                   0});
}

std::vector<BrickPoint> PlainLoopContender::createPoints()
{
    std::vector<BrickPoint> points;
    visitBricks(
        [&](Brick brick)
        {
            brick.openSides = findOpenSides(brick.getCell());
            if (brick.openSides != 0) points.push_back(packBrick(brick));
        });
    return points;
}

osg::ref_ptr<const BrickModel> PlainLoopContender::getBricks()
{
    std::vector<Brick> bricks;
    visitBricks([&bricks](const Brick& brick) { bricks.push_back(brick); });
    return BrickModel::create(getTriangles().getGrid(), std::move(bricks));
}

void PlainLoopContender::release()
{
    _cells = {};
    NativeContender::release();
}

} // namespace osgLego
