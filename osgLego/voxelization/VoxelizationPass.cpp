#include <osgLego/voxelization/VoxelizationPass.h>

#include <osgLego/data/PassConstants.h>
#include <osgLego/data/WeightedColor.h>
#include <osgLego/gl/GlMemory.h>
#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/passes/Addressing.h>
#include <osgLego/passes/GridVertexArrays.h>
#include <osgLego/voxelization/ProjectionPass.h>

#include <cmath>

#include <osg/BlendFunc>

namespace osgLego
{

namespace
{

constexpr int LOOKUP_UNIT = 1; // unit 0 is the surface's texture, or the picture

osg::ref_ptr<osg::Program> createProgram(const PassPlan& plan)
{
    if (plan.method == VoxelizationMethod::EXACT)
        return ShaderLibrary::createProgram("voxelization exact",
                                            {"voxelization/voxelization_exact.vert",
                                             "voxelization/voxelization_exact.geom",
                                             "voxelization/voxelization_exact.frag"},
                                            "#define MAXIMUM_CELLS " + std::to_string(plan.cellsPerTriangle) + "\n");
    if (plan.target == VoxelizationTarget::PROJECTED)
        return ShaderLibrary::createProgram("voxelization projected", {"voxelization/voxelization_projected.vert",
                                                                       "voxelization/voxelization_points.frag"});
    return ShaderLibrary::createProgram(
        "voxelization points", {"voxelization/voxelization_points.vert", "voxelization/voxelization_points.frag"});
}

/** The sum of weighted colours, and the sum of weights, that a texel of the exact method stands for, as in
 * shaders/passes/voxel_color.glsl. */
glm::vec4 sumOf(const glm::vec4& voxel)
{
    const float weights = std::isinf(voxel.a) ? static_cast<float>(PassConstants::LARGEST_SUM) : voxel.a;
    return {static_cast<float>(PassConstants::COLOR_CENTER) * weights + glm::vec3(voxel), weights};
}

} // namespace

VoxelizationPass::VoxelizationPass(PassWorkspace& workspace, unsigned int step, const PassPlan& plan, std::size_t slab,
                                   osg::Texture2D& voxelImage, osg::Texture2D* picture) :
    LegolizationPass(workspace, step),
    _plan(plan), _slab(slab)
{
    osg::ref_ptr<osg::StateSet> stateSet = createPassState(*createProgram(plan));
    if (plan.format != VoxelFormat::COLOR)
        stateSet->setAttributeAndModes(new osg::BlendFunc(osg::BlendFunc::ONE, osg::BlendFunc::ONE),
                                       osg::StateAttribute::ON | OVERRIDE_PROTECTED);
    if (picture) stateSet->setTextureAttribute(0, picture, OVERRIDE_PROTECTED);
    setStateSet(stateSet);
    setCamera(new PassCamera(*this, voxelImage, osg::Vec4()));
}

std::string VoxelizationPass::run(osg::State& state, Legolization& work) const
{
    if (!isTargetThere(state))
        return "there is not enough memory on the GPU for a voxel image of " + std::to_string(_plan.imageSize.x) +
               " x " + std::to_string(_plan.imageSize.y) + " texels; expected a lower resolution";

    const BrickGrid& grid = work.source->triangles->getGrid();
    const Slab slab = _plan.createSlabs(grid).slabs[_slab];
    const ProgramUniforms uniforms(state);
    setAddressing(uniforms, grid, slab, _plan.imageSize);
    uniforms.set("firstCell", work.source->triangles->getFirstCell());

    work.occupancy.clear(state, Occupancy::countBlocks(grid, slab));
    if (takeOutOfMemoryError())
        return "there is not enough memory on the GPU for the occupancy of the grid; expected a lower resolution";
    work.occupancy.beginMarking(state);
    if (_plan.method == VoxelizationMethod::EXACT)
        drawExact(state, work);
    else if (_plan.target == VoxelizationTarget::PROJECTED)
        drawPicture(state, work);
    else
        drawPoints(state, work);
    work.occupancy.endMarking(state);
    if (work.source->readBack) readBack(work, slab);
    return {};
}

void VoxelizationPass::drawExact(osg::State& state, const Legolization& work) const
{
    ProgramUniforms(state).set("sourceVertices", LOOKUP_UNIT);
    const GridVertexArrays arrays(*state.get<osg::GLExtensions>(), false);
    for (const WorkingBatch& batch : work.batches)
    {
        bindSurfaceOf(state, *batch.batch);
        state.setActiveTextureUnit(LOOKUP_UNIT);
        glBindTexture(GL_TEXTURE_BUFFER, batch.lookup.get());
        batch.bindFine(arrays);
        glDrawArrays(GL_TRIANGLES, 0, 3 * batch.numFineTriangles);
        glBindTexture(GL_TEXTURE_BUFFER, 0);
    }
}

void VoxelizationPass::drawPoints(osg::State& state, const Legolization& work) const
{
    const GridVertexArrays arrays(*state.get<osg::GLExtensions>());
    for (const WorkingBatch& batch : work.batches)
    {
        bindSurfaceOf(state, *batch.batch);
        batch.bindFine(arrays);
        glDrawArrays(GL_POINTS, 0, 3 * batch.numFineTriangles);
    }
}

void VoxelizationPass::drawPicture(osg::State& state, const Legolization& work) const
{
    ProgramUniforms(state).set("numberScale", ProjectionPass::getNumberScale(work.source->triangles->getGrid()));
    glDrawArrays(GL_POINTS, 0, _plan.pictureSize * _plan.pictureSize);
}

void VoxelizationPass::readBack(Legolization& work, const Slab& slab) const
{
    const glm::ivec3& dimensions = work.source->triangles->getGrid().dimensions;
    const std::size_t rowTexels = static_cast<std::size_t>(_plan.imageSize.x);
    std::vector<glm::vec4> texels(rowTexels * static_cast<std::size_t>(_plan.imageSize.y));
    glReadPixels(0, 0, _plan.imageSize.x, _plan.imageSize.y, GL_RGBA, GL_FLOAT, texels.data());

    std::size_t texel = static_cast<std::size_t>(slab.begin - slab.imageBegin) *
                        static_cast<std::size_t>(dimensions.x) * static_cast<std::size_t>(dimensions.y);
    const bool isWeighted = _plan.format != VoxelFormat::COLOR;
    for (int z = slab.begin; z < slab.end; ++z)
        for (int y = 0; y < dimensions.y; ++y)
            for (int x = 0; x < dimensions.x; ++x)
            {
                const glm::vec4& voxel = texels[texel++];
                if (!(voxel.a > 0.0f)) continue;
                work.readBack.push_back(makeBrick({x, y, z}, isWeighted ? sumOf(voxel) : voxel));
            }
}

} // namespace osgLego
