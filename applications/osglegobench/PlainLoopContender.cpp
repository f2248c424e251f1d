#include "PlainLoopContender.h"

#include "PublishedOverlap.h"

#include <algorithm>

#include <glm/common.hpp>
#include <osg/Timer>

namespace osgLego
{

namespace
{

Brick makeGreyBrick(const glm::ivec3& cell)
{
    return {
        {static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y), static_cast<std::uint16_t>(cell.z)},
        {160, 160, 160},
        0};
}

} // namespace

std::string PlainLoopContender::prepare(const BenchMesh& mesh, osg::GraphicsContext& context)
{
    _triangles = mesh.triangles;
    _dimensions = mesh.triangles->getGrid().dimensions;
    _cells.resize(mesh.triangles->getGrid().getNumCells());
    _buffer.prepare(context);
    return {};
}

double PlainLoopContender::run()
{
    const osg::Timer& timer = *osg::Timer::instance();
    const osg::Timer_t start = timer.tick();
    std::fill(_cells.begin(), _cells.end(), std::uint8_t(0));
    for (const GridBatch& batch : _triangles->getBatches())
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
            cover(&batch.vertices[first]);
    const osg::Timer_t middle = timer.tick();
    _buffer.upload(createPoints());
    const osg::Timer_t end = timer.tick();
    _coverage = timer.delta_m(start, middle);
    _points = timer.delta_m(middle, end);
    return _coverage + _points;
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
        const auto bit = 2 * static_cast<unsigned int>(axis); // of SIDE_LEFT and its like
        if (cell[axis] == 0 || _cells[numberOf(cell - step)] == 0) sides |= 1u << bit;
        if (cell[axis] + 1 == _dimensions[axis] || _cells[numberOf(cell + step)] == 0) sides |= 2u << bit;
    }
    return static_cast<std::uint8_t>(sides);
}

std::vector<BrickPoint> PlainLoopContender::createPoints() const
{
    std::vector<BrickPoint> points;
    std::size_t number = 0;
    for (int z = 0; z < _dimensions.z; ++z)
        for (int y = 0; y < _dimensions.y; ++y)
            for (int x = 0; x < _dimensions.x; ++x)
            {
                if (_cells[number++] == 0) continue;
                Brick brick = makeGreyBrick({x, y, z});
                brick.openSides = findOpenSides(brick.getCell());
                if (brick.openSides != 0) points.push_back(packBrick(brick));
            }
    return points;
}

osg::ref_ptr<const BrickModel> PlainLoopContender::getBricks()
{
    std::vector<Brick> bricks;
    std::size_t number = 0;
    for (int z = 0; z < _dimensions.z; ++z)
        for (int y = 0; y < _dimensions.y; ++y)
            for (int x = 0; x < _dimensions.x; ++x)
                if (_cells[number++] != 0) bricks.push_back(makeGreyBrick({x, y, z}));
    return BrickModel::create(_triangles->getGrid(), std::move(bricks));
}

void PlainLoopContender::release()
{
    _buffer.release();
    _cells = {};
    _triangles = nullptr;
}

std::vector<std::pair<std::string, double>> PlainLoopContender::getStageTimes() const
{
    return {{"coverage", _coverage}, {"points", _points}};
}

} // namespace osgLego
