#pragma once

#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>

namespace osgLego
{

/** Finds the bricks on the CPU (legolizeOnCpu), in place of the GPU's passes before the upload; the first pass of its
 * legolization.
 *
 * Where the plan leaves the device open, it does so only if the renderer turns out to be a software one. The bricks are
 * found once for all contexts, and for picking.
 */
class CpuVoxelizationPass : public LegolizationPass
{
public:
    CpuVoxelizationPass(BrickStore& store, const PassPlan& plan);

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const CpuVoxelizationPass*>(object) != nullptr;
    }
    const char* className() const override { return "CpuVoxelizationPass"; }

protected:
    bool hasProgram() const override { return false; }
    bool begin(osg::State& state, ContextBricks& bricks) const override;
    std::string run(osg::State& state, ContextBricks& bricks) const override;
    double& getTime(LegoStatistics& statistics) const override { return statistics.voxelization; }

private:
    PassPlan _plan;
};

} // namespace osgLego
