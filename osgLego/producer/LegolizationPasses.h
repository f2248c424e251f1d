#pragma once

#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>
#include <osgLego/passes/PassWorkspace.h>

#include <vector>

#include <osg/Referenced>
#include <osg/State>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The passes of a plan, in order: subdivision, the picture of a projected target, then for each slab of the grid
 * voxelization, the choice of dominant colours if there is a palette, and extraction. All slabs share their images. */
class LegolizationPasses : public osg::Referenced
{
public:
    LegolizationPasses(PassWorkspace& workspace, const PassPlan& plan);

    const PassPlan& getPlan() const { return _plan; }

    /** Queue all passes before the render stage that the visitor is filling. Call it once for each visitor and frame;
     * one thread at a time. */
    void cull(osgUtil::CullVisitor& visitor) const;

    void releaseGLObjects(osg::State* state) const;
    void resizeGLObjectBuffers(unsigned int maxSize) const;

private:
    ~LegolizationPasses() override = default;

    PassPlan _plan;
    std::vector<osg::ref_ptr<LegolizationPass>> _passes;
};

} // namespace osgLego
