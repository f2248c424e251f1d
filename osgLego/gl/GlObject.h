#pragma once

#include <utility>

#include <osg/ContextData>
#include <osg/GLExtensions>
#include <osg/GLObjects>
#include <osg/State>
#include <osg/observer_ptr>

namespace osgLego
{

/** Deletes one kind of GL object for one context, in that context's thread, when OSG flushes its deleted objects. */
template <void (*DELETE)(const osg::GLExtensions&, GLuint)>
class GlObjectManager : public osg::GLObjectManager
{
public:
    explicit GlObjectManager(unsigned int contextID) : osg::GLObjectManager("osgLego::GlObjectManager", contextID) {}

    void deleteGLObject(GLuint name) override
    {
        if (const osg::GLExtensions* extensions = osg::GLExtensions::Get(_contextID, false)) DELETE(*extensions, name);
    }
};

/** Owns the name of a GL object, a buffer or a texture, that contexts with the same ID share.
 *
 * Create it in a thread in which the context is current. It may be destroyed in any thread, which deletes the GL object
 * through OSG's deferred deletion. Nothing is deleted if the context has closed meanwhile, even if another context has
 * taken over its ID.
 */
template <void (*CREATE)(const osg::GLExtensions&, GLuint&), void (*DELETE)(const osg::GLExtensions&, GLuint)>
class GlObject
{
public:
    GlObject() = default;
    explicit GlObject(const osg::State& state) : _manager(osg::get<Manager>(state.getContextID()))
    {
        CREATE(*state.get<osg::GLExtensions>(), _name);
    }
    GlObject(GlObject&& other) noexcept : _manager(other._manager), _name(std::exchange(other._name, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(_manager, other._manager);
        std::swap(_name, other._name);
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;
    ~GlObject()
    {
        osg::ref_ptr<Manager> manager;
        if (_name != 0 && _manager.lock(manager)) manager->scheduleGLObjectForDeletion(_name);
    }

    /** Delete the GL object at once rather than after the frame. Needs a context that shares it current. */
    void deleteNow(const osg::State& state)
    {
        if (_name != 0) DELETE(*state.get<osg::GLExtensions>(), std::exchange(_name, 0));
    }

    /** The name to pass to GL; 0 if there is none. */
    GLuint get() const { return _name; }

private:
    using Manager = GlObjectManager<DELETE>;

    osg::observer_ptr<Manager> _manager;
    GLuint _name = 0;
};

inline void createGlBuffer(const osg::GLExtensions& extensions, GLuint& name)
{
    extensions.glGenBuffers(1, &name);
}
inline void deleteGlBuffer(const osg::GLExtensions& extensions, GLuint name)
{
    extensions.glDeleteBuffers(1, &name);
}
inline void createGlTexture(const osg::GLExtensions&, GLuint& name)
{
    glGenTextures(1, &name);
}
inline void deleteGlTexture(const osg::GLExtensions&, GLuint name)
{
    glDeleteTextures(1, &name);
}

using GlBuffer = GlObject<createGlBuffer, deleteGlBuffer>;
using GlTexture = GlObject<createGlTexture, deleteGlTexture>;

} // namespace osgLego
