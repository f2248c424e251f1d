#include <osgLego/voxelization/DominantColorPass.h>

#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/passes/Addressing.h>
#include <osgLego/voxelization/ExactCells.h>
#include <osgLego/voxelization/VoxelReader.h>

#include <osg/Depth>

namespace osgLego
{

namespace
{

constexpr int SUMS_UNIT = 2; // units 0 and 1 are the surface's texture and the source vertices

} // namespace

DominantColorPass::DominantColorPass(PassWorkspace& workspace, unsigned int step, const PassPlan& plan,
                                     std::size_t slab, const DominantColorTargets& targets) :
    LegolizationPass(workspace, step),
    _plan(plan), _slab(slab)
{
    osg::ref_ptr<osg::StateSet> stateSet = createPassState(targets.getProgram());
    stateSet->setAttributeAndModes(new osg::Depth(osg::Depth::LESS), osg::StateAttribute::ON | OVERRIDE_PROTECTED);
    stateSet->setTextureAttribute(SUMS_UNIT, &targets.getSums(), OVERRIDE_PROTECTED);
    setStateSet(stateSet);
    const osg::ref_ptr<PassCamera> camera = new PassCamera(*this, targets.getColors(), osg::Vec4());
    camera->addDepthBuffer(targets.getDepths());
    setCamera(camera);
}

std::string DominantColorPass::run(osg::State& state, Legolization& work) const
{
    if (!isTargetThere(state))
        return "there is not enough memory on the GPU for the dominant colours of " +
               std::to_string(_plan.imageSize.x) + " x " + std::to_string(_plan.imageSize.y) +
               " cells; expected a lower resolution, or palette=none";
    const BrickGrid& grid = work.source->triangles->getGrid();
    const Slab slab = _plan.createSlabs(grid).slabs[_slab];
    const ProgramUniforms uniforms(state);
    setAddressing(uniforms, grid, slab, _plan.imageSize);
    uniforms.set("firstCell", work.source->triangles->getFirstCell());
    uniforms.set("sums", SUMS_UNIT);
    drawExactCells(state, work, [&](const GridBatch& batch) { bindSurfaceOf(state, batch); });
    if (work.source->readBack) readBackBricks(VoxelFormat::COLOR, _plan.imageSize, slab, work);
    return {};
}

} // namespace osgLego
