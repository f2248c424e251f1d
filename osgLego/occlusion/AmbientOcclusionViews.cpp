#include <osgLego/occlusion/AmbientOcclusionViews.h>

#include <osgLego/gl/GlRequirements.h>

#include <algorithm>

#include <osg/GraphicsContext>
#include <osg/Notify>

namespace osgLego
{

namespace
{

constexpr int SAMPLES = 4; // supported by every GL

bool isColor(osg::Camera::BufferComponent component)
{
    return component == osg::Camera::COLOR_BUFFER || component >= osg::Camera::COLOR_BUFFER0;
}

bool drawsColors(const osg::Camera& camera)
{
    const auto& attachments = camera.getBufferAttachmentMap();
    return attachments.empty() ||
           std::any_of(attachments.begin(), attachments.end(), [](const auto& item) { return isColor(item.first); });
}

/** The number of samples of a camera's target. */
int samplesOf(const osg::Camera& camera, const osg::State& state)
{
    unsigned int samples = 0;
    const auto& attachments = camera.getBufferAttachmentMap();
    for (const auto& [component, attachment] : attachments)
        samples = std::max({samples, attachment._multisampleSamples});
    const osg::GraphicsContext* context = state.getGraphicsContext();
    if (attachments.empty() && context && context->getTraits()) samples = context->getTraits()->samples;
    return samples > 1 ? SAMPLES : 1;
}

} // namespace

osg::ref_ptr<AmbientOcclusionView> AmbientOcclusionViews::find(osgUtil::CullVisitor& visitor,
                                                               const AmbientOcclusionSettings& settings,
                                                               const LightProbe& probe)
{
    const osg::Camera* camera = visitor.getCurrentCamera();
    const osg::Viewport* viewport = visitor.getViewport();
    if (!camera || !viewport || viewport->width() < 1.0 || viewport->height() < 1.0 || !drawsColors(*camera)) return {};
    if (dynamic_cast<GeometryBufferStage*>(visitor.getCurrentRenderBin()->getStage())) return {};

    const osg::State& state = *visitor.getState();
    const std::lock_guard lock(_mutex);
    if (const osg::GLExtensions* extensions = state.get<osg::GLExtensions>())
    {
        const std::string missing = GlRequirements::getMissingVersion(*extensions);
        if (!missing.empty())
        {
            warn(state.getContextID(), missing);
            return {};
        }
    }

    OcclusionFormat format;
    format.size = {static_cast<int>(viewport->width()), static_cast<int>(viewport->height())};
    format.samples = samplesOf(*camera, state);
    format.quality = settings.quality;
    format.hasDistant = settings.hasDistant();
    osg::ref_ptr<AmbientOcclusionView>& view = _views.find(visitor);
    if (!view || view->getFormat() != format) view = new AmbientOcclusionView(format, getPrograms(format, probe));
    if (!view->hasFailed()) return view;
    warn(state.getContextID(), "there is not enough memory on the GPU for its buffers; expected a smaller viewport");
    return {};
}

const AmbientOcclusionPrograms& AmbientOcclusionViews::getPrograms(const OcclusionFormat& format,
                                                                   const LightProbe& probe)
{
    osg::ref_ptr<const AmbientOcclusionPrograms>& programs = _programs[{format.samples, format.quality}];
    if (!programs) programs = new AmbientOcclusionPrograms(format, probe);
    return *programs;
}

void AmbientOcclusionViews::warn(unsigned int contextID, const std::string& why)
{
    if (std::find(_warned.begin(), _warned.end(), contextID) != _warned.end()) return;
    _warned.push_back(contextID);
    OSG_WARN << "osgLego: no ambient occlusion: " << why << std::endl;
}

void AmbientOcclusionViews::clear()
{
    const std::lock_guard lock(_mutex);
    _views.clear();
    _programs.clear();
}

AmbientOcclusionTimes AmbientOcclusionViews::getTimes(unsigned int contextID) const
{
    const std::lock_guard lock(_mutex);
    const AmbientOcclusionView* latest = nullptr;
    unsigned int frame = 0;
    for (const auto& entry : _views.getEntries())
    {
        if (entry.contextID != contextID || !*entry.item || entry.frame < frame) continue;
        latest = *entry.item;
        frame = entry.frame;
    }
    return latest ? latest->getTimes() : AmbientOcclusionTimes();
}

void AmbientOcclusionViews::resizeGLObjectBuffers(unsigned int maxSize) const
{
    const std::lock_guard lock(_mutex);
    for (const auto& entry : _views.getEntries())
        if (*entry.item) (*entry.item)->resizeGLObjectBuffers(maxSize);
}

void AmbientOcclusionViews::releaseGLObjects(osg::State* state) const
{
    const std::lock_guard lock(_mutex);
    for (const auto& entry : _views.getEntries())
        if (*entry.item) (*entry.item)->releaseGLObjects(state);
}

} // namespace osgLego
