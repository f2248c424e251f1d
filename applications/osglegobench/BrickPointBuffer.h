#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BrickPoints.h>

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/GL>
#include <osg/GraphicsContext>

namespace osgLego
{

BrickPoint packBrickPoint(const glm::ivec3& cell, const std::array<std::uint8_t, 3>& color, unsigned int openSides);

/** The points of the bricks with an open side. */
std::vector<BrickPoint> packVisibleBricks(const BrickModel& bricks);

/** Where contenders on the CPU put their points, so that they end where those on the GPU do: in a buffer of GL.
 *
 * Every function but the constructor needs the context current. */
class BrickPointBuffer
{
public:
    void prepare(osg::GraphicsContext& context);
    /** Replace what is there, and wait until it is. */
    void upload(const std::vector<BrickPoint>& points) const;
    void release();

private:
    osg::GLExtensions* _extensions = nullptr;
    GLuint _name = 0;
};

} // namespace osgLego
