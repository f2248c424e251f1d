#pragma once

#include <string>

#include <EGL/egl.h>
#include <osg/GraphicsContext>

namespace osgLego
{

/** A graphics context that draws into an EGL pixel buffer; it needs neither a display nor a window system. */
class EglContext : public osg::GraphicsContext
{
public:
    explicit EglContext(Traits* traits);

    /** Why realize() failed. */
    const std::string& getError() const { return _error; }

    bool valid() const override { return true; }
    bool realizeImplementation() override;
    bool isRealizedImplementation() const override { return _context != EGL_NO_CONTEXT; }
    void closeImplementation() override;
    bool makeCurrentImplementation() override;
    bool makeContextCurrentImplementation(osg::GraphicsContext* readContext) override;
    bool releaseContextImplementation() override;
    void bindPBufferToTextureImplementation(GLenum) override {}
    void swapBuffersImplementation() override {}

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const EglContext*>(object) != nullptr;
    }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "EglContext"; }

private:
    ~EglContext() override;

    /** @param attributes as for eglCreateContext. */
    bool realizeOn(EGLDisplay display, const EGLint* attributes);

    EGLDisplay _display = EGL_NO_DISPLAY;
    EGLContext _context = EGL_NO_CONTEXT;
    EGLSurface _surface = EGL_NO_SURFACE;
    std::string _error;
};

} // namespace osgLego
