#pragma once

#include <osgLego/passes/BrickStore.h>
#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>

#include <vector>

#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The passes of a plan in their order. On the GPU: subdivision, the picture of a projected target, and for each slab
 * of the grid voxelization and extraction, all slabs sharing one voxel image. On the CPU: voxelization, and the upload.
 */
class LegolizationPasses : public osg::Referenced
{
public:
    LegolizationPasses(BrickStore& store, const PassPlan& plan);

    const PassPlan& getPlan() const { return _plan; }

    /** Queue every pass to be drawn before the stage that the visitor is filling.
     * Once for each visitor and frame; one thread at a time. */
    void cull(osgUtil::CullVisitor& visitor) const;

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize) const;

private:
    ~LegolizationPasses() override = default;

    void addGpuPasses(BrickStore& store);

    PassPlan _plan;
    std::vector<osg::ref_ptr<LegolizationPass>> _passes;
};

} // namespace osgLego
