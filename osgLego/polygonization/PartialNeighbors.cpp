#include <osgLego/polygonization/PartialNeighbors.h>

#include <osgLego/data/BrickNeighbors.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/TransformFeedback.h>
#include <osgLego/polygonization/BrickSplats.h>
#include <osgLego/polygonization/BrickUniforms.h>
#include <osgLego/polygonization/GridOcclusionView.h>

#include <osg/GLExtensions>

namespace osgLego
{

namespace
{

void bindRanks(osg::State& state, GLuint texture)
{
    state.setActiveTextureUnit(GridOcclusionView::NEIGHBORS_UNIT);
    glBindTexture(GL_TEXTURE_BUFFER, texture);
    // See GridOcclusionView::apply().
    state.setActiveTextureUnit(0);
}

} // namespace

const GridOcclusionTextures* findPartialNeighbors(osg::State& state, ContextBricks& context, const DrawnBricks& bricks,
                                                  const BrickStates& states)
{
    PartialOcclusion* const occlusion = context.findPartialOcclusion(state);
    if (!occlusion || occlusion->numPlaced == bricks.numPlaced) return occlusion ? &occlusion->getTextures() : nullptr;
    const bool isApplied = applyBrickState(state, states.getPartialNeighbors());
    if (isApplied)
    {
        setPartUniforms(state, bricks);
        const ProgramUniforms uniforms(state);
        uniforms.set("cellRanks", static_cast<int>(GridOcclusionView::NEIGHBORS_UNIT));
        uniforms.set("gridSize", bricks.grid.dimensions);
        bindRanks(state, occlusion->getRanks());
        TransformFeedback feedback(*state.get<osg::GLExtensions>());
        feedback.begin(GL_POINTS, occlusion->getTextures().getBuffer(), 0,
                       static_cast<GLsizeiptr>(static_cast<std::size_t>(bricks.count) * sizeof(BrickNeighbors)));
        drawAllBrickPoints(state, bricks);
        feedback.end();
        bindRanks(state, 0);
        occlusion->numPlaced = bricks.numPlaced;
    }
    applyBrickState(state, states.getTriangles());
    return isApplied ? &occlusion->getTextures() : nullptr;
}

} // namespace osgLego
