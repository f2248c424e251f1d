#include <osgLego/producer/CpuVoxelizationPass.h>

#include <osgLego/gl/GlRequirements.h>

namespace osgLego
{

CpuVoxelizationPass::CpuVoxelizationPass(BrickStore& store, const PassPlan& plan) :
    LegolizationPass(store, 0), _plan(plan)
{
    setCamera(new PassCamera(*this));
}

bool CpuVoxelizationPass::begin(osg::State& state, ContextBricks& bricks) const
{
    const bool isOpen = _plan.device == Device::AUTO;
    if (isOpen && GlRequirements::getRenderer(state.getContextID()) != Renderer::SOFTWARE) return false;
    return start(state, bricks, _plan);
}

std::string CpuVoxelizationPass::run(osg::State&, ContextBricks& bricks) const
{
    Legolization& work = *bricks.work;
    work.statistics.isFromCpu = true;
    work.model = getStore().getModel(*work.source);
    return {};
}

} // namespace osgLego
