#include <osgLego/AmbientOcclusionView.h>

#include <osgLego/LightProbeState.h>
#include <osgLego/OcclusionNoise.h>
#include <osgLego/PerVisit.h>
#include <osgLego/ShaderLibrary.h>

#include <string>

#include <osg/BlendFunc>
#include <osg/ColorMask>
#include <osg/Texture2D>
#include <osg/Texture2DMultisample>
#include <osg/Uniform>
#include <osg/Viewport>

namespace osgLego
{

namespace
{

constexpr float NOTHING = -1e15f; // beyond that of shaders/view_position.glsl
// Behind what is opaque in the frame around, before what is transparent.
constexpr int COMPOSITE_BIN = osg::StateSet::TRANSPARENT_BIN - 1;

/** What a quality stands for. Few steps miss what is between them, and no pixel knows what is hidden behind others;
 * both leave pictures too bright, which radius and power make good. They were found by `osglegobench occlusion` on its
 * first view. */
struct Effort
{
    int slices;   // by pixel
    int steps;    // to each side of a slice
    float radius; // over the one that is asked for
    float power;  // of visibility
};

Effort effortOf(AmbientOcclusionQuality quality)
{
    switch (quality)
    {
    case AmbientOcclusionQuality::LOW:
        return {2, 6, 1.2f, 1.15f};
    case AmbientOcclusionQuality::HIGH:
        return {4, 10, 1.25f, 1.05f};
    case AmbientOcclusionQuality::MEDIUM:
        break;
    }
    return {3, 8, 1.2f, 1.1f};
}

void setUpTexture(osg::Texture& texture, GLint internalFormat, GLenum format, GLenum type)
{
    texture.setInternalFormat(internalFormat);
    texture.setSourceFormat(format);
    texture.setSourceType(type);
    texture.setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture.setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture.setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture.setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
}

osg::ref_ptr<osg::Texture2D> createTexture(const glm::ivec2& size, GLint internalFormat, GLenum format, GLenum type)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(size.x, size.y);
    texture->setResizeNonPowerOfTwoHint(false);
    setUpTexture(*texture, internalFormat, format, type);
    return texture;
}

osg::ref_ptr<osg::Texture2D> createColorTexture(const glm::ivec2& size, GLint internalFormat)
{
    return createTexture(size, internalFormat, GL_RGBA, GL_FLOAT);
}

/** A texture with the samples of a format, to be attached to a frame buffer object. */
osg::ref_ptr<osg::Texture> createTarget(const AmbientOcclusionView::Format& format, GLint internalFormat, GLenum pixels)
{
    if (format.samples == 1) return createTexture(format.size, internalFormat, pixels, GL_FLOAT);
    osg::ref_ptr<osg::Texture2DMultisample> texture = new osg::Texture2DMultisample(format.samples, GL_TRUE);
    texture->setTextureSize(format.size.x, format.size.y);
    setUpTexture(*texture, internalFormat, pixels, GL_FLOAT);
    // Textures of several samples have no borders, so that it is without effect but one: OSG takes
    // glTexImage2DMultisample instead of glTextureStorage2DMultisample, which it calls for a texture that is none.
    texture->setBorderWidth(1);
    return texture;
}

void attach(osg::FrameBufferObject& buffer, osg::Camera::BufferComponent component, osg::Texture& texture)
{
    if (auto* plain = dynamic_cast<osg::Texture2D*>(&texture))
        buffer.setAttachment(component, osg::FrameBufferAttachment(plain));
    else
        buffer.setAttachment(component, osg::FrameBufferAttachment(dynamic_cast<osg::Texture2DMultisample*>(&texture)));
}

osg::ref_ptr<osg::Program> createProgram(const char* pass, const std::string& definitions)
{
    return ShaderLibrary::createProgram(pass, {"screen.vert", (std::string(pass) + ".frag").c_str()}, definitions);
}

std::string define(const char* name, int value)
{
    return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

/** The place of a state graph's state with another in the place of one of its state sets. */
osgUtil::StateGraph* replaceState(osgUtil::StateGraph* graph, const osg::StateSet& from, const osg::StateSet& to)
{
    if (!graph->_parent) return graph;
    const osg::StateSet* state = graph->getStateSet() == &from ? &to : graph->getStateSet();
    return replaceState(graph->_parent, from, to)->find_or_insert(state);
}

/** Draw in the frame around what a stage has that is transparent: nothing there needs occlusion, and all of it must
 * come after what is opaque on both sides.
 * @param inside the state of the stage.
 * @param outside what stands for it in the frame around. */
void handOnTransparent(osgUtil::RenderStage& stage, osgUtil::RenderBin& outer, const osg::StateSet& inside,
                       const osg::StateSet& outside)
{
    osgUtil::RenderBin::RenderBinList& bins = stage.getRenderBinList();
    for (auto place = bins.lower_bound(osg::StateSet::TRANSPARENT_BIN); place != bins.end();)
    {
        osgUtil::RenderBin& from = *place->second;
        const bool isSorted = from.getSortMode() == osgUtil::RenderBin::SORT_BACK_TO_FRONT;
        osgUtil::RenderBin* to = outer.find_or_insert(place->first, isSorted ? "DepthSortedBin" : "RenderBin");
        for (osgUtil::StateGraph* graph : from.getStateGraphList())
        {
            osgUtil::StateGraph* moved = replaceState(graph, inside, outside);
            if (moved->leaves_empty()) to->addStateGraph(moved);
            for (const osg::ref_ptr<osgUtil::RenderLeaf>& leaf : graph->_leaves)
                moved->addLeaf(leaf);
            graph->_leaves.clear();
        }
        place = bins.erase(place);
    }
}

/** Let lights and clip planes among the children act on the frame around, as those of other groups do. */
void handOnPositionalState(osgUtil::RenderStage& stage, osgUtil::RenderStage& outer)
{
    osgUtil::PositionalStateContainer& state = *stage.getPositionalStateContainer();
    for (const auto& [attribute, matrix] : state.getAttrMatrixList())
        outer.addPositionedAttribute(matrix, attribute);
    for (const auto& [unit, attributes] : state.getTexUnitAttrMatrixListMap())
        for (const auto& [attribute, matrix] : attributes)
            outer.addPositionedTextureAttribute(unit, matrix, attribute);
}

} // namespace

AmbientOcclusionView::AmbientOcclusionView(const Format& format, const LightProbe& probe) :
    _format(format), _stage(new GeometryBufferStage), _geometryBuffer(new osg::FrameBufferObject),
    _childState(new osg::StateSet), _transparentState(new osg::StateSet)
{
    // The viewport of the camera is part of the state above, and has another origin.
    _childState->setAttribute(new osg::Viewport(0, 0, format.size.x, format.size.y));
    createGeometryBuffer();
    createPasses(probe);
}

void AmbientOcclusionView::createGeometryBuffer()
{
    _light = createTarget(_format, GL_RGBA16F_ARB, GL_RGBA);
    _albedo = createTarget(_format, GL_RGBA8, GL_RGBA);
    _normals = createTarget(_format, GL_RGBA16F_ARB, GL_RGBA);
    _depth = createTarget(_format, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    attach(*_geometryBuffer, osg::Camera::COLOR_BUFFER0, *_light);
    attach(*_geometryBuffer, osg::Camera::COLOR_BUFFER1, *_albedo);
    attach(*_geometryBuffer, osg::Camera::COLOR_BUFFER2, *_normals);
    attach(*_geometryBuffer, osg::Camera::DEPTH_BUFFER, *_depth);
}

void AmbientOcclusionView::createPasses(const LightProbe& probe)
{
    const Effort effort = effortOf(_format.quality);
    const osg::Vec4 nothing(NOTHING, 0.0f, 0.0f, 0.0f);
    const osg::ref_ptr<osg::Texture2D> depthImage = createColorTexture(_format.size, GL_RG32F);
    const osg::ref_ptr<osg::Program> resolve = createProgram("occlusion_resolve", define("SAMPLES", _format.samples));
    osg::ref_ptr<osg::Texture> light = _light;
    osg::ref_ptr<osg::Texture> albedo = _albedo;
    osg::ref_ptr<osg::Texture> normals = _normals;
    if (_format.samples == 1)
    {
        _resolve = new ScreenPass(*resolve, {{"depthBuffer", _depth}});
        _resolve->setTargets({depthImage}, nothing);
    }
    else
    {
        const auto resolved = [&](GLint format) { return createColorTexture(_format.size, format); };
        const osg::ref_ptr<osg::Texture2D> lights = resolved(GL_RGBA16F_ARB);
        const osg::ref_ptr<osg::Texture2D> albedos = resolved(GL_RGBA8);
        const osg::ref_ptr<osg::Texture2D> allNormals = resolved(GL_RGBA16F_ARB);
        _resolve = new ScreenPass(
            *resolve,
            {{"lightBuffer", _light}, {"albedoBuffer", _albedo}, {"normalBuffer", _normals}, {"depthBuffer", _depth}});
        _resolve->setTargets({depthImage, lights, albedos, allNormals}, nothing);
        light = lights;
        albedo = albedos;
        normals = allNormals;
    }

    const osg::ref_ptr<osg::Texture2D> rough = createColorTexture(_format.size, GL_RGBA16F_ARB);
    _occlusion =
        new ScreenPass(*createProgram("occlusion", define("SLICES", effort.slices) + define("STEPS", effort.steps)),
                       {{"normalBuffer", normals}, {"depthImage", depthImage}, {"noise", createOcclusionNoise()}});
    _occlusion->setTargets({rough}, osg::Vec4());
    _radius = _occlusion->getStateSet()->getOrCreateUniform("radius", osg::Uniform::FLOAT);
    _occlusion->getStateSet()->addUniform(
        new osg::Uniform("falloff", static_cast<float>(AmbientOcclusionSettings::FALLOFF)));

    const osg::ref_ptr<osg::Texture2D> smooth = createColorTexture(_format.size, GL_RGBA16F_ARB);
    _denoise = new ScreenPass(*createProgram("occlusion_denoise", ""),
                              {{"occlusion", rough}, {"depthImage", depthImage}, {"normalBuffer", normals}});
    _denoise->setTargets({smooth}, osg::Vec4());
    _denoise->getStateSet()->addUniform(new osg::Uniform("power", effort.power));
    _denoise->getStateSet()->addUniform(_radius);

    _composite = new ScreenPass(*createProgram("occlusion_composite", ""), {{"lightBuffer", light},
                                                                            {"albedoBuffer", albedo},
                                                                            {"normalBuffer", normals},
                                                                            {"depthImage", depthImage},
                                                                            {"occlusion", smooth}});
    osg::StateSet& state = *_composite->getStateSet();
    state.setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA), osg::StateAttribute::ON |
                                                                                       osg::StateAttribute::OVERRIDE |
                                                                                       osg::StateAttribute::PROTECTED);
    state.setRenderBinDetails(COMPOSITE_BIN, "RenderBin");
    _shown = state.getOrCreateUniform("shown", osg::Uniform::INT);
    applyLightProbe(probe, state);
    _composite->setSource(*_stage);
}

void AmbientOcclusionView::setUpStage(osgUtil::RenderStage& outer)
{
    _stage->reset();
    _stage->setFrameBufferObject(_geometryBuffer);
    _stage->setViewport(new osg::Viewport(0, 0, _format.size.x, _format.size.y));
    _stage->setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    _stage->setClearColor(osg::Vec4());
    _stage->setInitialViewMatrix(outer.getInitialViewMatrix());
    _stage->inheritPositionalState(outer);
}

void AmbientOcclusionView::cull(osgUtil::CullVisitor& visitor, const AmbientOcclusionSettings& settings,
                                double sceneRadius, const std::function<void()>& cullChildren)
{
    osgUtil::RenderBin* outerBin = visitor.getCurrentRenderBin();
    osgUtil::RenderStage& outer = *outerBin->getStage();
    setUpStage(outer);
    visitor.setCurrentRenderBin(_stage);
    visitor.pushStateSet(_childState);
    cullChildren();
    visitor.popStateSet();
    visitor.setCurrentRenderBin(outerBin);
    handOnTransparent(*_stage, *outerBin, *_childState, *_transparentState);
    handOnPositionalState(*_stage, outer);
    outer.addPreRenderStage(_stage);

    const double pitch = _stage->getPitch();
    const double usual = pitch > 0.0 ? AmbientOcclusionSettings::RADIUS_IN_BRICKS * pitch : 0.1 * sceneRadius;
    _radius->set(effortOf(_format.quality).radius * static_cast<float>(settings.radius.value_or(usual)));
    _shown->set(static_cast<int>(settings.output));
    const osg::Matrixd eyeToWorld = computeEyeToWorld(visitor);
    const osg::Viewport* viewport = visitor.getViewport();
    const glm::ivec2 origin(viewport->x(), viewport->y());
    for (const osg::ref_ptr<ScreenPass>& pass : {_resolve, _occlusion, _denoise, _composite})
    {
        pass->setView(*visitor.getProjectionMatrix(), eyeToWorld, origin, _format.size);
        pass->getNode().accept(visitor);
    }
}

void AmbientOcclusionView::setTiming(bool timing)
{
    for (const osg::ref_ptr<ScreenPass>& pass : {_resolve, _occlusion, _denoise, _composite})
        pass->setTiming(timing);
    _stage->setTiming(timing);
}

AmbientOcclusionTimes AmbientOcclusionView::getTimes() const
{
    return {_stage->getTime(), _resolve->getTime(), _occlusion->getTime(), _denoise->getTime(), _composite->getTime()};
}

void AmbientOcclusionView::resizeGLObjectBuffers(unsigned int maxSize) const
{
    _geometryBuffer->resizeGLObjectBuffers(maxSize);
    for (const osg::ref_ptr<ScreenPass>& pass : {_resolve, _occlusion, _denoise, _composite})
        pass->resizeGLObjectBuffers(maxSize);
}

void AmbientOcclusionView::releaseGLObjects(osg::State* state) const
{
    _geometryBuffer->releaseGLObjects(state);
    for (const osg::ref_ptr<ScreenPass>& pass : {_resolve, _occlusion, _denoise, _composite})
        pass->releaseGLObjects(state);
}

} // namespace osgLego
