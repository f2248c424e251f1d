#pragma once

#include <osgLego/data/BrickPoints.h>

#include <vector>

#include <osg/GL>
#include <osg/GraphicsContext>

namespace osgLego
{

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
