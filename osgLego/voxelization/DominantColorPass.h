#pragma once

#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>
#include <osgLego/voxelization/DominantColorTargets.h>

namespace osgLego
{

/** Chooses one colour for each covered cell of a slab out of those that triangles contribute to it: the colour nearest
 * to their mean, as DominantColors does on the CPU.
 *
 * It draws the points of exact voxelization again. Their depth is their distance from the mean, which voxelization has
 * summed up, so that the depth test keeps the nearest.
 */
class DominantColorPass : public LegolizationPass
{
public:
    /** @param slab the number of the slab. */
    DominantColorPass(PassWorkspace& workspace, unsigned int step, const PassPlan& plan, std::size_t slab,
                      const DominantColorTargets& targets);

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const DominantColorPass*>(object) != nullptr;
    }
    const char* className() const override { return "DominantColorPass"; }

protected:
    std::string run(osg::State& state, Legolization& work) const override;
    double& getTime(LegoStatistics& statistics) const override { return statistics.voxelization; }

private:
    PassPlan _plan;
    std::size_t _slab;
};

} // namespace osgLego
