#include <osgLego/SurfaceBinding.h>

#include <osgLego/ProgramUniforms.h>

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

void bindSurface(osg::State& state, const BrickStore& store, const GridBatch& batch)
{
    ProgramUniforms(state).set("textureEnvironment", numberOf(batch));
    if (!batch.texture) return;
    const osg::ref_ptr<osg::Texture2D> texture = store.getTexture(*batch.texture);
    state.applyTextureAttribute(0, texture.get());
    state.haveAppliedTextureAttribute(0, texture.get());
}

} // namespace osgLego
