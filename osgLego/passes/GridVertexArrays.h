#pragma once

#include <osg/GL>
#include <osg/GLExtensions>

namespace osgLego
{

/** Feeds buffers of GridVertex to a vertex shader, attribute locations 0 to 3, as long as it lives.
 *
 * Expects, and leaves behind, no vertex array enabled and no array buffer bound. Needs its context current.
 */
class GridVertexArrays
{
public:
    explicit GridVertexArrays(const osg::GLExtensions& extensions);
    ~GridVertexArrays();
    GridVertexArrays(const GridVertexArrays&) = delete;
    GridVertexArrays& operator=(const GridVertexArrays&) = delete;

    /** Take the vertices from here on out of `buffer`. */
    void bind(GLuint buffer) const;

private:
    const osg::GLExtensions& _extensions;
};

} // namespace osgLego
