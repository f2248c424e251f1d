#pragma once

#include <string>
#include <vector>

#include <GL/osmesa.h>
#include <osg/GraphicsContext>

namespace osgLego
{

/** A graphics context of Mesa's off-screen library: it draws in software, in memory, and produces the same pictures on
 * every run.
 *
 * OSMesa provides about 150 GL functions through OSMesaGetProcAddress only. OSG looks them up elsewhere and finds stubs
 * that do nothing. Neither osgLego nor OSG on its behalf calls any of these functions.
 */
class OsMesaContext : public osg::GraphicsContext
{
public:
    explicit OsMesaContext(Traits* traits);

    /** Why realize() failed. */
    const std::string& getError() const { return _error; }

    bool valid() const override { return true; }
    bool realizeImplementation() override;
    bool isRealizedImplementation() const override { return _context != nullptr; }
    void closeImplementation() override;
    bool makeCurrentImplementation() override;
    bool makeContextCurrentImplementation(osg::GraphicsContext* readContext) override;
    bool releaseContextImplementation() override;
    void bindPBufferToTextureImplementation(GLenum) override {}
    void swapBuffersImplementation() override {}

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const OsMesaContext*>(object) != nullptr;
    }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "OsMesaContext"; }

private:
    ~OsMesaContext() override;

    OSMesaContext _context = nullptr;
    std::vector<unsigned char> _pixels;
    std::string _error;
};

} // namespace osgLego
