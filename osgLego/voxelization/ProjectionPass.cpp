#include <osgLego/voxelization/ProjectionPass.h>

#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/passes/GridVertexArrays.h>

#include <bit>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <osg/Depth>

namespace osgLego
{

namespace
{

const glm::vec3 UPWARD(0.0f, 0.0f, 1.0f);

/** Bounds in the directions of the picture. */
struct SeenBounds
{
    glm::vec3 minimum{std::numeric_limits<float>::max()};
    glm::vec3 maximum{std::numeric_limits<float>::lowest()};

    void add(const glm::vec3& seen)
    {
        minimum = glm::min(minimum, seen);
        maximum = glm::max(maximum, seen);
    }
};

/** The projection from positions to a picture that the triangles in the grid fill, since pixels beside them would be
 * wasted. */
glm::mat4 projectionOf(const GridTriangles& triangles)
{
    const glm::mat4 view = glm::lookAt(glm::vec3(0.0f), -ProjectionPass::getDirection(), UPWARD);
    const glm::mat3 turn(view);
    SeenBounds ofTriangles;
    for (const GridBatch& batch : triangles.getBatches())
        for (const GridVertex& vertex : batch.vertices)
            ofTriangles.add(turn * vertex.position);
    SeenBounds ofGrid;
    const glm::vec3 size(triangles.getGrid().dimensions);
    for (int corner = 0; corner < 8; ++corner)
        ofGrid.add(turn *
                   (glm::vec3(triangles.getFirstCell()) + size * glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2)));
    // Keeps rounding from moving points out of the picture.
    constexpr float MARGIN = 0.01f;
    const glm::vec3 minimum = glm::max(ofTriangles.minimum, ofGrid.minimum) - MARGIN;
    const glm::vec3 maximum = glm::min(ofTriangles.maximum, ofGrid.maximum) + MARGIN;
    return glm::ortho(minimum.x, maximum.x, minimum.y, maximum.y, -maximum.z, -minimum.z) * view;
}

} // namespace

ProjectionPass::ProjectionPass(PassWorkspace& workspace, unsigned int step, osg::Texture2D& picture) :
    LegolizationPass(workspace, step)
{
    osg::ref_ptr<osg::StateSet> stateSet = createPassState(
        *ShaderLibrary::getProgram("projection", {"voxelization/projection.vert", "voxelization/projection.frag"}));
    stateSet->setAttributeAndModes(new osg::Depth(osg::Depth::LESS), osg::StateAttribute::ON | OVERRIDE_PROTECTED);
    setStateSet(stateSet);
    // Alpha below 0 marks empty pixels, because 0 is the number of a cell.
    const osg::ref_ptr<PassCamera> camera = new PassCamera(*this, picture, osg::Vec4(0.0f, 0.0f, 0.0f, -1.0f));
    camera->addDepthBuffer();
    setCamera(camera);
}

glm::vec3 ProjectionPass::getDirection()
{
    // Parallel neither to an axis nor to a diagonal of the axes.
    return {0.48f, 0.62f, 0.37f};
}

float ProjectionPass::getNumberScale(const BrickGrid& grid)
{
    return static_cast<float>(std::bit_ceil(grid.getNumCells()));
}

std::string ProjectionPass::run(osg::State& state, Legolization& work) const
{
    if (!isTargetThere(state))
        return "there is not enough memory on the GPU for the picture of the projected target; expected a smaller fbo";
    const BrickGrid& grid = work.source->triangles->getGrid();
    const ProgramUniforms uniforms(state);
    uniforms.set("projection", projectionOf(*work.source->triangles));
    uniforms.set("gridSize", grid.dimensions);
    uniforms.set("firstCell", work.source->triangles->getFirstCell());
    uniforms.set("numberScale", getNumberScale(grid));
    const GridVertexArrays arrays(*state.get<osg::GLExtensions>());
    for (const WorkingBatch& batch : work.batches)
    {
        bindSurfaceOf(state, *batch.batch);
        batch.bindFine(arrays);
        glDrawArrays(GL_POINTS, 0, 3 * batch.numFineTriangles);
    }
    return {};
}

} // namespace osgLego
