#include "MeshDrawing.h"

#include <osgLego/GridVertexArrays.h>
#include <osgLego/ProgramUniforms.h>

namespace osgLego
{

namespace
{

osg::ref_ptr<osg::Texture2D> createTexture(const SurfaceTexture& surface)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(surface.getImage());
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, surface.getWrapS());
    texture->setWrap(osg::Texture::WRAP_T, surface.getWrapT());
    texture->setBorderColor(surface.getBorderColor());
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

/** As surface_color.glsl counts them. */
int numberOf(const GridBatch& batch)
{
    if (!batch.texture) return 0;
    switch (batch.environment)
    {
    case TextureEnvironment::REPLACE:
        return 2;
    case TextureEnvironment::DECAL:
        return 3;
    case TextureEnvironment::ADD:
        return 4;
    case TextureEnvironment::MODULATE:
        break;
    }
    return 1;
}

} // namespace

void MeshDrawing::create(osg::State& state, const GridTriangles& triangles)
{
    _triangles = &triangles;
    _batches.clear();
    for (const GridBatch& source : triangles.getBatches())
    {
        osg::ref_ptr<osg::Texture2D> texture;
        if (source.texture)
        {
            texture = createTexture(*source.texture);
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
    const ProgramUniforms uniforms(state);
    const GridVertexArrays arrays(*state.get<osg::GLExtensions>());
    for (const Batch& batch : _batches)
    {
        uniforms.set("textureEnvironment", numberOf(*batch.source));
        if (batch.texture)
        {
            state.applyTextureAttribute(0, batch.texture.get());
            state.haveAppliedTextureAttribute(0, batch.texture.get());
        }
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
