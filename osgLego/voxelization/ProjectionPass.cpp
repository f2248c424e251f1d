#include <osgLego/voxelization/ProjectionPass.h>

#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/passes/GridVertexArrays.h>

#include <bit>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace osgLego
{

namespace
{

// Parallel neither to an axis nor to a diagonal of the axes.
const glm::vec3 DIRECTION(0.48f, 0.62f, 0.37f);
const glm::vec3 UPWARD(0.0f, 0.0f, 1.0f);

/** The projection from positions to a picture that contains the whole grid. */
glm::mat4 projectionOf(const BrickGrid& grid, const glm::ivec3& firstCell)
{
    const glm::vec3 size(grid.dimensions);
    const glm::mat4 view = glm::lookAt(glm::vec3(0.0f), -DIRECTION, UPWARD);
    glm::vec3 minimum(std::numeric_limits<float>::max());
    glm::vec3 maximum(std::numeric_limits<float>::lowest());
    for (int corner = 0; corner < 8; ++corner)
    {
        const glm::vec3 place = size * glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::vec3 seen(view * glm::vec4(place, 1.0f));
        minimum = glm::min(minimum, seen);
        maximum = glm::max(maximum, seen);
    }
    constexpr float MARGIN = 0.5f;
    return glm::ortho(minimum.x, maximum.x, minimum.y, maximum.y, -maximum.z - MARGIN, -minimum.z + MARGIN) * view *
           glm::translate(glm::mat4(1.0f), glm::vec3(-firstCell));
}

} // namespace

ProjectionPass::ProjectionPass(PassWorkspace& workspace, unsigned int step, osg::Texture2D& picture) :
    LegolizationPass(workspace, step)
{
    setStateSet(createPassState(
        *ShaderLibrary::createProgram("projection", {"voxelization/projection.vert", "voxelization/projection.frag"})));
    // Alpha below 0 marks empty pixels, because 0 is the number of a cell.
    setCamera(new PassCamera(*this, picture, osg::Vec4(0.0f, 0.0f, 0.0f, -1.0f)));
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
    uniforms.set("projection", projectionOf(grid, work.source->triangles->getFirstCell()));
    uniforms.set("gridSize", grid.dimensions);
    uniforms.set("firstCell", work.source->triangles->getFirstCell());
    uniforms.set("numberScale", getNumberScale(grid));
    const GridVertexArrays arrays(*state.get<osg::GLExtensions>());
    for (const WorkingBatch& batch : work.batches)
    {
        bindSurfaceOf(state, *batch.batch);
        arrays.bind(batch.getFineBuffer());
        glDrawArrays(GL_POINTS, 0, 3 * batch.numFineTriangles);
    }
    return {};
}

} // namespace osgLego
