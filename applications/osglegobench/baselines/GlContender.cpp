#include "GlContender.h"

#include "GlRestoration.h"

#include <osgLego/gl/GlMemory.h>
#include <osgLego/gl/ShaderLibrary.h>

#include <osg/GLObjects>
#include <osg/Timer>

namespace osgLego
{

/** The shaders of this folder by their names; made at build time, see CMakeLists.txt. */
const ShaderLibrary::Sources& getBaselineShaders();

std::string GlContender::prepare(const BenchMesh& mesh, osg::GraphicsContext& context)
{
    ShaderLibrary::add(getBaselineShaders());
    _state = context.getState();
    _triangles = mesh.triangles;
    const GlRestoration restoration(*_state);
    _drawing.create(*_state, *_triangles);
    std::string error = createObjects(*_state);
    if (takeOutOfMemoryError() && error.empty()) error = "there is no room for textures of this grid's size";
    return error;
}

double GlContender::run()
{
    const GlRestoration restoration(*_state);
    glFinish();
    const osg::Timer& timer = *osg::Timer::instance();
    const osg::Timer_t start = timer.tick();
    _drawing.upload(*_state);
    findBricks(*_state);
    glFinish();
    return timer.delta_m(start, timer.tick());
}

osg::ref_ptr<const BrickModel> GlContender::getBricks()
{
    const GlRestoration restoration(*_state);
    return readBricks(*_state);
}

void GlContender::release()
{
    releaseObjects();
    _drawing.release();
    _triangles = nullptr;
    // At once: the next contender may need the room.
    if (_state.valid()) osg::flushAllDeletedGLObjects(_state->getContextID());
    _state = nullptr;
}

} // namespace osgLego
