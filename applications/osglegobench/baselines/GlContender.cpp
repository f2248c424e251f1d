#include "GlContender.h"

#include "GlRestoration.h"

#include <osgLego/gl/GlMemory.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/passes/GridVertexArrays.h>
#include <osgLego/passes/SurfaceBinding.h>

#include <osg/GLObjects>
#include <osg/Timer>

namespace osgLego
{

/** The shaders in this folder by name; generated at build time, see CMakeLists.txt. */
const ShaderLibrary::Sources& getBaselineShaders();

std::string GlContender::prepare(const BenchMesh& mesh, osg::GraphicsContext& context)
{
    ShaderLibrary::add(getBaselineShaders());
    _state = context.getState();
    _triangles = mesh.triangles;
    const GlRestoration restoration(*_state);
    createBatches(*_state);
    std::string error = createObjects(*_state);
    if (takeOutOfMemoryError() && error.empty()) error = "there is not enough memory for textures of this grid's size";
    return error;
}

void GlContender::createBatches(osg::State& state)
{
    _batches.clear();
    for (const GridBatch& source : _triangles->getBatches())
    {
        osg::ref_ptr<osg::Texture2D> texture;
        if (source.texture)
        {
            texture = createSurfaceTexture(*source.texture);
            state.applyTextureAttribute(0, texture.get());
        }
        _batches.push_back({&source, GlBuffer(state), texture});
    }
}

double GlContender::run()
{
    const GlRestoration restoration(*_state);
    glFinish();
    const osg::Timer& timer = *osg::Timer::instance();
    const osg::Timer_t start = timer.tick();
    upload(*_state);
    findBricks(*_state);
    glFinish();
    return timer.delta_m(start, timer.tick());
}

void GlContender::upload(const osg::State& state) const
{
    for (const Batch& batch : _batches)
        uploadBuffer(state, GL_ARRAY_BUFFER, batch.buffer, batch.source->vertices, GL_STREAM_DRAW);
}

void GlContender::draw(osg::State& state) const
{
    const GridVertexArrays arrays(*state.get<osg::GLExtensions>());
    for (const Batch& batch : _batches)
    {
        bindSurface(state, *batch.source, batch.texture.get());
        arrays.bind(batch.buffer.get());
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(batch.source->vertices.size()));
    }
}

osg::ref_ptr<const BrickModel> GlContender::getBricks()
{
    const GlRestoration restoration(*_state);
    return readBricks(*_state);
}

void GlContender::release()
{
    releaseObjects();
    _batches.clear();
    _triangles = nullptr;
    // Release immediately: the next contender may need the memory.
    if (_state.valid()) osg::flushAllDeletedGLObjects(_state->getContextID());
    _state = nullptr;
}

} // namespace osgLego
