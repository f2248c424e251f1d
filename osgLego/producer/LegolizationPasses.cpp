#include <osgLego/producer/LegolizationPasses.h>

#include <osgLego/extraction/BrickExtractionPass.h>
#include <osgLego/producer/BrickUploadPass.h>
#include <osgLego/producer/CpuVoxelizationPass.h>
#include <osgLego/subdivision/SubdivisionPass.h>
#include <osgLego/voxelization/ProjectionPass.h>
#include <osgLego/voxelization/VoxelizationPass.h>

namespace osgLego
{

LegolizationPasses::LegolizationPasses(BrickStore& store, const PassPlan& plan) : _plan(plan)
{
    if (plan.device != Device::GPU)
    {
        _passes.emplace_back(new CpuVoxelizationPass(store, plan));
        _passes.emplace_back(new BrickUploadPass(store));
    }
    if (plan.device != Device::CPU) addGpuPasses(store);
}

void LegolizationPasses::addGpuPasses(BrickStore& store)
{
    const PassPlan& plan = _plan;
    unsigned int step = 0;
    _passes.emplace_back(new SubdivisionPass(store, plan));
    osg::ref_ptr<osg::Texture2D> picture;
    if (plan.pictureSize > 0)
    {
        picture = PassCamera::createTarget(glm::ivec2(plan.pictureSize));
        _passes.emplace_back(new ProjectionPass(store, ++step, *picture));
    }
    const osg::ref_ptr<osg::Texture2D> voxelImage = PassCamera::createTarget(plan.imageSize);
    const osg::ref_ptr<const ExtractionStates> extraction = new ExtractionStates(*voxelImage);
    for (std::size_t slab = 0; slab < plan.numSlabs; ++slab)
    {
        _passes.emplace_back(new VoxelizationPass(store, ++step, plan, slab, *voxelImage, picture.get()));
        _passes.emplace_back(new BrickExtractionPass(store, ++step, plan, slab, *extraction));
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
