#include "MeshDrawing.h"

#include <osgLego/passes/GridVertexArrays.h>
#include <osgLego/passes/SurfaceBinding.h>

namespace osgLego
{

void MeshDrawing::create(osg::State& state, const GridTriangles& triangles)
{
    _triangles = &triangles;
    _batches.clear();
    for (const GridBatch& source : triangles.getBatches())
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

void MeshDrawing::upload(const osg::State& state) const
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    for (const Batch& batch : _batches)
    {
        const std::vector<GridVertex>& vertices = batch.source->vertices;
        extensions.glBindBuffer(GL_ARRAY_BUFFER, batch.buffer.get());
        extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(GridVertex)),
                                vertices.data(), GL_STREAM_DRAW);
    }
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void MeshDrawing::draw(osg::State& state) const
{
    const GridVertexArrays arrays(*state.get<osg::GLExtensions>());
    for (const Batch& batch : _batches)
    {
        bindSurface(state, *batch.source, batch.texture.get());
        arrays.bind(batch.buffer.get());
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(batch.source->vertices.size()));
    }
}

void MeshDrawing::release()
{
    _batches.clear();
    _triangles = nullptr;
}

} // namespace osgLego
