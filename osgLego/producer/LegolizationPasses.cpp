#include <osgLego/producer/LegolizationPasses.h>

#include <osgLego/extraction/BrickExtractionPass.h>
#include <osgLego/subdivision/SubdivisionPass.h>
#include <osgLego/voxelization/DominantColorPass.h>
#include <osgLego/voxelization/ProjectionPass.h>
#include <osgLego/voxelization/VoxelizationPass.h>

namespace osgLego
{

LegolizationPasses::LegolizationPasses(PassWorkspace& workspace, const PassPlan& plan) : _plan(plan)
{
    unsigned int step = 0;
    _passes.emplace_back(new SubdivisionPass(workspace, plan));
    osg::ref_ptr<osg::Texture2D> picture;
    if (plan.pictureSize > 0)
    {
        picture = PassCamera::createTarget(glm::ivec2(plan.pictureSize), GL_RGBA32F_ARB);
        _passes.emplace_back(new ProjectionPass(workspace, ++step, *picture));
    }
    const osg::ref_ptr<osg::Texture2D> voxelImage =
        PassCamera::createTarget(plan.imageSize, internalFormatOf(plan.format));
    const osg::ref_ptr<const DominantColorTargets> dominant =
        plan.findsDominantColors() ? new DominantColorTargets(plan, *voxelImage) : nullptr;
    const osg::ref_ptr<const ExtractionStates> extraction =
        new ExtractionStates(dominant ? dominant->getColors() : *voxelImage, plan);
    for (std::size_t slab = 0; slab < plan.numSlabs; ++slab)
    {
        _passes.emplace_back(new VoxelizationPass(workspace, ++step, plan, slab, *voxelImage, picture.get()));
        if (dominant) _passes.emplace_back(new DominantColorPass(workspace, ++step, plan, slab, *dominant));
        _passes.emplace_back(new BrickExtractionPass(workspace, ++step, plan, slab, *extraction));
    }
}

void LegolizationPasses::cull(osgUtil::CullVisitor& visitor) const
{
    for (const osg::ref_ptr<LegolizationPass>& pass : _passes)
        pass->getCamera().accept(visitor);
}

void LegolizationPasses::releaseGLObjects(osg::State* state) const
{
    for (const osg::ref_ptr<LegolizationPass>& pass : _passes)
        pass->releaseGLObjects(state);
}

void LegolizationPasses::resizeGLObjectBuffers(unsigned int maxSize) const
{
    for (const osg::ref_ptr<LegolizationPass>& pass : _passes)
        pass->resizeGLObjectBuffers(maxSize);
}

} // namespace osgLego
