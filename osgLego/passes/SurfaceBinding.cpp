#include <osgLego/passes/SurfaceBinding.h>

#include <osgLego/gl/ProgramUniforms.h>

namespace osgLego
{

namespace
{

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

osg::ref_ptr<osg::Texture2D> createSurfaceTexture(const SurfaceTexture& surface)
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

void bindSurface(osg::State& state, const GridBatch& batch, osg::Texture2D* texture)
{
    ProgramUniforms(state).set("textureEnvironment", numberOf(batch));
    if (!texture) return;
    state.applyTextureAttribute(0, texture);
    state.haveAppliedTextureAttribute(0, texture);
}

} // namespace osgLego
