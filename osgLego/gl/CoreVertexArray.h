#pragma once

#include <osg/GLExtensions>
#include <osg/State>

namespace osgLego
{

/** A vertex array object that is bound during the lifetime of this object: contexts of the core profile, where this is
 * needed, draw nothing without one. Does nothing in other contexts.
 *
 * It is created for each drawing, since contexts that share other objects don't share vertex array objects. Needs the
 * context of `state` current.
 */
class CoreVertexArray
{
public:
    explicit CoreVertexArray(const osg::State& state);
    ~CoreVertexArray();
    CoreVertexArray(const CoreVertexArray&) = delete;
    CoreVertexArray& operator=(const CoreVertexArray&) = delete;

private:
    const osg::GLExtensions* _extensions = nullptr; // null outside of the core profile
    GLint _previous = 0;
    GLuint _name = 0;
};

} // namespace osgLego
