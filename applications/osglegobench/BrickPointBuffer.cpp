#include "BrickPointBuffer.h"

#include <osg/GLExtensions>

namespace osgLego
{

BrickPoint packBrickPoint(const glm::ivec3& cell, const std::array<std::uint8_t, 3>& color, unsigned int openSides)
{
    constexpr std::uint32_t OPAQUE = 0xff000000u;
    const glm::uvec3 place(cell);
    return {place.x | place.y << 16, place.z | openSides << 16,
            OPAQUE | static_cast<std::uint32_t>(color[0]) | static_cast<std::uint32_t>(color[1]) << 8 |
                static_cast<std::uint32_t>(color[2]) << 16};
}

std::vector<BrickPoint> packVisibleBricks(const BrickModel& bricks)
{
    std::vector<BrickPoint> points;
    points.reserve(bricks.getBricks().size());
    for (const Brick& brick : bricks.getBricks())
        if (brick.openSides != 0)
            points.push_back(
                packBrickPoint({brick.cell[0], brick.cell[1], brick.cell[2]}, brick.color, brick.openSides));
    return points;
}

void BrickPointBuffer::prepare(osg::GraphicsContext& context)
{
    release();
    _extensions = osg::GLExtensions::Get(context.getState()->getContextID(), true);
    _extensions->glGenBuffers(1, &_name);
}

void BrickPointBuffer::upload(const std::vector<BrickPoint>& points) const
{
    _extensions->glBindBuffer(GL_ARRAY_BUFFER, _name);
    _extensions->glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(BrickPoint)),
                              points.data(), GL_STATIC_DRAW);
    _extensions->glBindBuffer(GL_ARRAY_BUFFER, 0);
    glFinish();
}

void BrickPointBuffer::release()
{
    if (_name != 0) _extensions->glDeleteBuffers(1, &_name);
    _name = 0;
}

} // namespace osgLego
