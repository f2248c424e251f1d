#include <osgLego/AmbientOcclusionScene.h>

#include <osgLego/occlusion/AmbientOcclusionViews.h>

#include <osg/Notify>
#include <osgUtil/CullVisitor>

namespace osgLego
{

AmbientOcclusionScene::AmbientOcclusionScene() : _views(new AmbientOcclusionViews), _lightProbe(new LightProbe) {}

AmbientOcclusionScene::AmbientOcclusionScene(const AmbientOcclusionScene& scene, const osg::CopyOp& copyop) :
    osg::Group(scene, copyop), _enabled(scene._enabled), _settings(scene._settings), _views(new AmbientOcclusionViews),
    _lightProbe(scene._lightProbe), _timing(scene._timing)
{
}

AmbientOcclusionScene::~AmbientOcclusionScene() = default;

bool AmbientOcclusionScene::setSettings(const AmbientOcclusionSettings& settings)
{
    if (const std::string error = settings.check(); !error.empty())
    {
        OSG_WARN << "osgLego: " << error << std::endl;
        return false;
    }
    _settings = settings;
    return true;
}

void AmbientOcclusionScene::setLightProbe(const LightProbe* probe)
{
    // A copy, since it is read while frames are culled.
    _lightProbe = probe ? new LightProbe(*probe) : new LightProbe;
    _views->clear();
}

AmbientOcclusionTimes AmbientOcclusionScene::getTimes(unsigned int contextID) const
{
    return _views->getTimes(contextID);
}

void AmbientOcclusionScene::traverse(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* cullVisitor = visitor.asCullVisitor();
    osg::ref_ptr<AmbientOcclusionView> view;
    if (_enabled && cullVisitor) view = _views->find(*cullVisitor, _settings, *_lightProbe);
    if (!view)
    {
        osg::Group::traverse(visitor);
        return;
    }
    view->setTiming(_timing);
    view->cull(*cullVisitor, _settings, getBound(), isCullingActive(), [&] { osg::Group::traverse(visitor); });
}

void AmbientOcclusionScene::resizeGLObjectBuffers(unsigned int maxSize)
{
    osg::Group::resizeGLObjectBuffers(maxSize);
    _views->resizeGLObjectBuffers(maxSize);
}

void AmbientOcclusionScene::releaseGLObjects(osg::State* state) const
{
    osg::Group::releaseGLObjects(state);
    _views->releaseGLObjects(state);
}

} // namespace osgLego
