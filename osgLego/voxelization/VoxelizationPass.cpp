#include <osgLego/voxelization/VoxelizationPass.h>

#include <osgLego/gl/GlMemory.h>
#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/passes/Addressing.h>
#include <osgLego/passes/GridVertexArrays.h>
#include <osgLego/voxelization/ExactCells.h>
#include <osgLego/voxelization/ProjectionPass.h>
#include <osgLego/voxelization/VoxelReader.h>

#include <osg/BlendFunc>

namespace osgLego
{

namespace
{

osg::ref_ptr<osg::Program> getProgram(const PassPlan& plan)
{
    if (plan.method == VoxelizationMethod::EXACT)
        return getExactCellsProgram("voxelization exact", "voxelization/voxelization_exact.frag",
                                    plan.cellsPerTriangle);
    if (plan.target == VoxelizationTarget::PROJECTED)
        return ShaderLibrary::getProgram("voxelization projected", {"voxelization/voxelization_projected.vert",
                                                                    "voxelization/voxelization_points.frag"});
    return ShaderLibrary::getProgram(
        "voxelization points", {"voxelization/voxelization_points.vert", "voxelization/voxelization_points.frag"});
}

} // namespace

VoxelizationPass::VoxelizationPass(PassWorkspace& workspace, unsigned int step, const PassPlan& plan, std::size_t slab,
                                   osg::Texture2D& voxelImage, osg::Texture2D* picture) :
    LegolizationPass(workspace, step),
    _plan(plan), _slab(slab)
{
    osg::ref_ptr<osg::StateSet> stateSet = createPassState(*getProgram(plan));
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
        drawExactCells(state, work, [&](const GridBatch& batch) { bindSurfaceOf(state, batch); });
    else if (_plan.target == VoxelizationTarget::PROJECTED)
        drawPicture(state, work);
    else
        drawPoints(state, work);
    work.occupancy.endMarking(state);
    if (work.source->readBack && !_plan.findsDominantColors())
        readBackBricks(_plan.format, _plan.imageSize, slab, work);
    return {};
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

} // namespace osgLego
