#include <osgLego/polygonization/GridOcclusionView.h>

#include <osgLego/gl/ProgramUniforms.h>

namespace osgLego
{

void GridOcclusionView::apply(osg::State& state) const
{
    static const UniformName COUNT("numNeighbors");
    static const UniformName PIXEL_WIDTH("cellPixelWidth");
    const ProgramUniforms uniforms(state);
    uniforms.set(COUNT, _occlusion ? static_cast<int>(_occlusion->getCount()) : 0);
    uniforms.set(PIXEL_WIDTH, _pixelWidth);
    if (_occlusion)
    {
        state.applyTextureAttribute(TABLE_UNIT, &_occlusion->getTable());
        state.applyTextureAttribute(STUDS_UNIT, &_occlusion->getStuds());
    }
    state.setActiveTextureUnit(NEIGHBORS_UNIT);
    glBindTexture(GL_TEXTURE_BUFFER, _occlusion ? _occlusion->getNeighbors() : 0);
    // If the unit of a buffer texture is the active one, Mesa 22.3.6 may read zeros from it after a change of programs.
    state.setActiveTextureUnit(0);
}

} // namespace osgLego
