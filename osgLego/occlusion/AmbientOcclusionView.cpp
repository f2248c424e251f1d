#include <osgLego/occlusion/AmbientOcclusionView.h>

#include <osgLego/gl/PerVisit.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/SharedGlObjects.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/light/LightProbeState.h>
#include <osgLego/occlusion/OcclusionNoise.h>
#include <osgLego/polygonization/PictureTiles.h>

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

constexpr float NOTHING = -1e15f; // beyond NOTHING in shaders/occlusion/view_position.glsl
// After the opaque nodes of the outer frame, before the transparent ones.
constexpr int COMPOSITE_BIN = osg::StateSet::TRANSPARENT_BIN - 1;

/** The parameters of a quality. Few steps miss occluders between them, and surfaces hidden behind others are unknown;
 * both make pictures too bright. Radius and power compensate for this; they were fitted with `osglegobench occlusion`
 * on its first view. */
struct Effort
{
    int slices;   // per pixel
    int steps;    // on each side of a slice
    float radius; // factor for the radius in the settings
    float power;  // exponent applied to visibility
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
    return {3, 8, 1.3f, 1.03f};
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

/** Make OSG allocate a texture with glTexImage2DMultisample.
 *
 * For a texture without a border, OSG 3.6.5 calls its pointer to glTexStorage2DMultisample, but has loaded it with
 * glTextureStorage2DMultisample, which expects the name of a texture instead of a target: GL reports an error, and the
 * texture gets no memory. A multisample texture never has a border, and OSG does not use the border width for anything
 * else, so a width of 1 has no other effect. The alternatives are more invasive: GLExtensions could be corrected, but
 * is shared by everything drawn in a context, and a class that overrides Texture2DMultisample::apply() would have to
 * duplicate it. */
void avoidTextureStorage(osg::Texture2DMultisample& texture)
{
    texture.setBorderWidth(1);
}

/** Create a texture with a format's number of samples, for a frame buffer object. */
osg::ref_ptr<osg::Texture> createTarget(const OcclusionFormat& format, GLint internalFormat, GLenum pixels)
{
    if (format.samples == 1) return createTexture(format.size, internalFormat, pixels, GL_FLOAT);
    osg::ref_ptr<osg::Texture2DMultisample> texture = new osg::Texture2DMultisample(format.samples, GL_TRUE);
    texture->setTextureSize(format.size.x, format.size.y);
    setUpTexture(*texture, internalFormat, pixels, GL_FLOAT);
    avoidTextureStorage(*texture);
    return texture;
}

void attach(osg::FrameBufferObject& buffer, osg::Camera::BufferComponent component, osg::Texture& texture)
{
    if (auto* plain = dynamic_cast<osg::Texture2D*>(&texture))
        buffer.setAttachment(component, osg::FrameBufferAttachment(plain));
    else
        buffer.setAttachment(component, osg::FrameBufferAttachment(dynamic_cast<osg::Texture2DMultisample*>(&texture)));
}

osg::ref_ptr<osg::Program> getProgram(const char* pass, const char* vertexShader, const std::string& definitions)
{
    return ShaderLibrary::getProgram(pass, {vertexShader, ("occlusion/" + std::string(pass) + ".frag").c_str()},
                                     definitions);
}

std::string define(const char* name, int value)
{
    return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

/** Find the state graph for the same path of state sets as `graph`, with `from` replaced by `to`. */
osgUtil::StateGraph* replaceState(osgUtil::StateGraph* graph, const osg::StateSet& from, const osg::StateSet& to)
{
    if (!graph->_parent) return graph;
    const osg::StateSet* state = graph->getStateSet() == &from ? &to : graph->getStateSet();
    return replaceState(graph->_parent, from, to)->find_or_insert(state);
}

/** The prototype name of a render bin. */
const char* kindOf(const osgUtil::RenderBin& bin)
{
    if (bin.getSortMode() == osgUtil::RenderBin::SORT_BACK_TO_FRONT) return "DepthSortedBin";
    return bin.getSortMode() == osgUtil::RenderBin::TRAVERSAL_ORDER ? "TraversalOrderBin" : "RenderBin";
}

/** Moves transparent nodes from a stage to the outer frame: they need no occlusion, and must be drawn after all opaque
 * nodes, inside and outside. */
class TransparentHandOver
{
public:
    /** @param inside the state of the stage.
     * @param outside the state that replaces it in the outer frame. */
    TransparentHandOver(const osg::StateSet& inside, const osg::StateSet& outside) : _inside(inside), _outside(outside)
    {
    }

    /** Move the transparent bins inside a bin, at any depth. */
    void handOn(osgUtil::RenderBin& from, osgUtil::RenderBin& outer) const
    {
        osgUtil::RenderBin::RenderBinList& bins = from.getRenderBinList();
        for (auto place = bins.begin(); place != bins.end();)
        {
            if (place->first < osg::StateSet::TRANSPARENT_BIN)
            {
                handOn(*place->second, outer);
                ++place;
                continue;
            }
            moveAll(*place->second, *outer.find_or_insert(place->first, kindOf(*place->second)));
            place = bins.erase(place);
        }
    }

private:
    void moveAll(osgUtil::RenderBin& from, osgUtil::RenderBin& to) const
    {
        for (osgUtil::StateGraph* graph : from.getStateGraphList())
        {
            osgUtil::StateGraph* moved = replaceState(graph, _inside, _outside);
            if (moved->leaves_empty()) to.addStateGraph(moved);
            for (const osg::ref_ptr<osgUtil::RenderLeaf>& leaf : graph->_leaves)
                moved->addLeaf(leaf);
            graph->_leaves.clear();
        }
        for (const auto& [number, bin] : from.getRenderBinList())
            moveAll(*bin, *to.find_or_insert(number, kindOf(*bin)));
    }

    const osg::StateSet& _inside;
    const osg::StateSet& _outside;
};

} // namespace

AmbientOcclusionPrograms::AmbientOcclusionPrograms(const OcclusionFormat& format, const LightProbe& probe) :
    noise(createOcclusionNoise()), light(new osg::StateSet)
{
    const Effort effort = effortOf(format.quality);
    std::string definitions = define("SAMPLES", format.samples) + define("SLICES", effort.slices) +
                              define("STEPS", effort.steps) + define("TILE", PictureTiles::SIDE);
    constexpr const char* SCREEN = "occlusion/screen.vert";
    constexpr const char* TILES = "occlusion/screen_tiles.vert";
    resolve = getProgram("occlusion_resolve", SCREEN, definitions);
    tiles = getProgram("occlusion_tiles", SCREEN, definitions);
    occlusion = getProgram("occlusion", TILES, definitions);
    denoise = getProgram("occlusion_denoise", TILES, definitions);
    composite = getProgram("occlusion_composite", TILES, definitions + defineLightProbe(probe));
    applyLightProbe(probe, *light);
}

AmbientOcclusionView::AmbientOcclusionView(const OcclusionFormat& format, const AmbientOcclusionPrograms& programs) :
    _format(format), _programs(&programs), _stage(new GeometryBufferStage), _geometryBuffer(new osg::FrameBufferObject),
    _childState(new osg::StateSet), _transparentState(new osg::StateSet)
{
    _stage->setDistantOcclusion(format.hasDistant);
    // The state above includes the camera's viewport, which has a different origin.
    _childState->setAttribute(new osg::Viewport(0, 0, format.size.x, format.size.y));
    // Colour masks and blending are applied to the composite; the buffer does not contain colours.
    _childState->setAttribute(new osg::ColorMask, OVERRIDE_PROTECTED);
    _childState->setMode(GL_SCISSOR_TEST, osg::StateAttribute::OFF | OVERRIDE_PROTECTED);
    createGeometryBuffer();
    createPasses();
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
    _brickOcclusion = createTarget(_format, GL_RGBA8, GL_RGBA);
    attach(*_geometryBuffer, osg::Camera::COLOR_BUFFER3, *_brickOcclusion);
}

AmbientOcclusionView::~AmbientOcclusionView()
{
    SharedGlObjects::get().removeUser(this);
}

void AmbientOcclusionView::createPasses()
{
    const Effort effort = effortOf(_format.quality);
    const auto create = [&](GLint format) { return createColorTexture(_format.size, format); };
    const osg::Vec4 nothing(NOTHING, 0.0f, 0.0f, 0.0f);
    osg::ref_ptr<osg::Texture> light = _light;
    osg::ref_ptr<osg::Texture> albedo = _albedo;
    osg::ref_ptr<osg::Texture> normals = _normals;
    osg::ref_ptr<osg::Texture> brickOcclusion = _brickOcclusion;
    osg::ref_ptr<osg::Texture2D> depthImage;
    if (_format.samples == 1)
    {
        depthImage = create(GL_RG32F);
        _resolve = new ScreenPass(*_programs->resolve, {{"lightBuffer", _light},
                                                        {"normalBuffer", _normals},
                                                        {"depthBuffer", _depth},
                                                        {"brickOcclusion", _brickOcclusion}});
        _resolve->setTargets({depthImage}, nothing);
    }
    else
    {
        std::vector<osg::ref_ptr<osg::Texture2D>> targets{create(GL_RG32F), create(GL_RGBA16F_ARB), create(GL_RGBA8),
                                                          create(GL_RGBA16F_ARB), create(GL_RGBA8)};
        _resolve = new ScreenPass(*_programs->resolve, {{"lightBuffer", _light},
                                                        {"albedoBuffer", _albedo},
                                                        {"normalBuffer", _normals},
                                                        {"depthBuffer", _depth},
                                                        {"brickOcclusion", _brickOcclusion}});
        _resolve->setTargets(targets, nothing);
        depthImage = targets[0];
        light = targets[1];
        albedo = targets[2];
        normals = targets[3];
        brickOcclusion = targets[4];
    }

    const osg::ref_ptr<osg::Texture2D> tiles =
        createColorTexture((_format.size + PictureTiles::SIDE - 1) / PictureTiles::SIDE, GL_R8);
    _tiles = new ScreenPass(*_programs->tiles, {{"depthImage", depthImage}});
    _tiles->setTargets({tiles}, osg::Vec4(), PictureTiles::SIDE);

    const osg::ref_ptr<osg::Texture2D> rough = create(GL_RGBA16F_ARB);
    _occlusion = new ScreenPass(*_programs->occlusion,
                                {{"normalBuffer", normals}, {"depthImage", depthImage}, {"noise", _programs->noise}});
    _occlusion->setTargets({rough}, osg::Vec4());
    _radius = _occlusion->getStateSet()->getOrCreateUniform("radius", osg::Uniform::FLOAT);
    _occlusion->getStateSet()->addUniform(
        new osg::Uniform("falloff", static_cast<float>(AmbientOcclusionSettings::FALLOFF)));

    const osg::ref_ptr<osg::Texture2D> smooth = create(GL_RGBA16F_ARB);
    _denoise = new ScreenPass(*_programs->denoise,
                              {{"occlusion", rough}, {"depthImage", depthImage}, {"normalBuffer", normals}});
    _denoise->setTargets({smooth}, osg::Vec4());
    _denoise->getStateSet()->addUniform(new osg::Uniform("power", effort.power));
    _denoise->getStateSet()->addUniform(_radius);

    _composite = new ScreenPass(*_programs->composite, {{"lightBuffer", light},
                                                        {"albedoBuffer", albedo},
                                                        {"normalBuffer", normals},
                                                        {"depthImage", depthImage},
                                                        {"occlusion", smooth},
                                                        {"brickOcclusion", brickOcclusion}});
    osg::StateSet& state = *_composite->getStateSet();
    state.setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA), osg::StateAttribute::ON |
                                                                                       osg::StateAttribute::OVERRIDE |
                                                                                       osg::StateAttribute::PROTECTED);
    state.setRenderBinDetails(COMPOSITE_BIN, "RenderBin");
    state.addUniform(_radius);
    _shown = state.getOrCreateUniform("shown", osg::Uniform::INT);
    state.merge(*_programs->light);
    _composite->setSource(*_stage);
    for (const osg::ref_ptr<ScreenPass>& pass : {_occlusion, _denoise, _composite})
        pass->setTiles(*tiles);
    _passes = {_resolve, _tiles, _occlusion, _denoise, _composite};
}

void AmbientOcclusionView::setUpStage(osgUtil::RenderStage& outer)
{
    _stage->resetFor(outer);
    _stage->setFrameBufferObject(_geometryBuffer);
    // Cameras among the children may inherit it.
    _stage->setViewport(new osg::Viewport(0, 0, _format.size.x, _format.size.y));
    _stage->setInitialViewMatrix(outer.getInitialViewMatrix());
}

void AmbientOcclusionView::cull(osgUtil::CullVisitor& visitor, const AmbientOcclusionSettings& settings,
                                const osg::BoundingSphere& bound, bool hasBounds,
                                const std::function<void()>& cullChildren)
{
    SharedGlObjects::get().addUser(visitor.getState()->getContextID(), this);
    osgUtil::RenderBin* outerBin = visitor.getCurrentRenderBin();
    osgUtil::RenderStage& outer = *outerBin->getStage();
    setUpStage(outer);
    visitor.pushStateSet(_childState);
    _stage->cull(visitor, cullChildren);
    visitor.popStateSet();
    TransparentHandOver(*_childState, *_transparentState).handOn(*_stage, *outerBin);
    _stage->handOnPostRenderStages(outer);
    PictureArea area{glm::ivec2(0), _format.size};
    if (hasBounds) area = findArea(*_stage, _format.size);
    // The stage is drawn in any case: cameras among the children are drawn before it.
    if (area.isEmpty()) area = {glm::ivec2(0), glm::ivec2(1)};
    const glm::ivec2 size = area.getSize();
    _stage->setViewport(new osg::Viewport(area.begin.x, area.begin.y, size.x, size.y));
    outer.addPreRenderStage(_stage, ScreenPass::RENDER_ORDER);

    const double pitch = _stage->getPitch();
    const osg::Matrixd& modelView = *visitor.getModelViewMatrix();
    const double scale = osg::Matrixd::transform3x3(osg::Vec3d(1.0, 0.0, 0.0), modelView).length();
    const double usual =
        pitch > 0.0 ? AmbientOcclusionSettings::RADIUS_IN_BRICKS * pitch : 0.1 * scale * bound.radius();
    _radius->set(effortOf(_format.quality).radius * static_cast<float>(settings.radius.value_or(usual)));
    _shown->set(static_cast<int>(settings.output));
    const osg::Viewport* viewport = visitor.getViewport();
    const PassView view{visitor.getProjectionMatrix(),
                        rotationOf(computeEyeToWorld(visitor)),
                        glm::ivec2(viewport->x(), viewport->y()),
                        _format.size,
                        area,
                        bound};
    for (const osg::ref_ptr<ScreenPass>& pass : _passes)
    {
        pass->setView(view);
        pass->cull(visitor);
    }
}

void AmbientOcclusionView::setTiming(bool timing)
{
    for (const osg::ref_ptr<ScreenPass>& pass : _passes)
        pass->setTiming(timing);
    _stage->setTiming(timing);
}

AmbientOcclusionTimes AmbientOcclusionView::getTimes() const
{
    return {_stage->getTime(), _resolve->getTime() + _tiles->getTime(), _occlusion->getTime(), _denoise->getTime(),
            _composite->getTime()};
}

void AmbientOcclusionView::resizeGLObjectBuffers(unsigned int maxSize) const
{
    _geometryBuffer->resizeGLObjectBuffers(maxSize);
    for (const osg::ref_ptr<ScreenPass>& pass : _passes)
        pass->resizeGLObjectBuffers(maxSize);
}

void AmbientOcclusionView::releaseGLObjects(osg::State* state) const
{
    _geometryBuffer->releaseGLObjects(state);
    for (const osg::ref_ptr<ScreenPass>& pass : _passes)
        pass->releaseGLObjects(state);
    SharedGlObjects::get().release(state, this);
}

} // namespace osgLego
