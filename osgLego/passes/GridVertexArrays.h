#pragma once

#include <osg/GL>
#include <osg/GLExtensions>

namespace osgLego
{

/** Feeds buffers of GridVertex to the attribute locations 0 to 3 of a vertex shader during its lifetime.
 *
 * No vertex array may be enabled and no array buffer bound before, and none is afterwards. Needs its context current.
 */
class GridVertexArrays
{
public:
    explicit GridVertexArrays(const osg::GLExtensions& extensions);
    ~GridVertexArrays();
    GridVertexArrays(const GridVertexArrays&) = delete;
    GridVertexArrays& operator=(const GridVertexArrays&) = delete;

    /** Read the vertices of the following draw calls from `buffer`. */
    void bind(GLuint buffer) const;

private:
    const osg::GLExtensions& _extensions;
};

} // namespace osgLego
