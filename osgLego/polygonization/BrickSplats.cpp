#include <osgLego/polygonization/BrickSplats.h>

#include <osgLego/gl/GlObject.h>
#include <osgLego/gl/GlRequirements.h>
#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/polygonization/BrickUniforms.h>

#include <algorithm>
#include <array>

#include <osg/ContextData>
#include <osg/Depth>
#include <osg/FrameBufferObject>
#include <osg/GraphicsContext>
#include <osg/Texture2D>
#include <osg/Uniform>
#include <osg/observer_ptr>

namespace osgLego
{

namespace
{

// Different from the units of the relief, of distant occlusion and of the light probe.
constexpr unsigned int BRICKS_UNIT = 1;
constexpr unsigned int SPLATS_UNIT = 4;
constexpr unsigned int DEPTHS_UNIT = 5;
constexpr GLsizei WORDS_PER_BRICK = 3;
// The number of bricks that the splats of a partly built model can distinguish; see splat_rays.glsl.
constexpr GLsizei MAXIMUM_PARTIAL = 1 << 23;

/** Create a texture to draw into and to fetch texels from; its size is set later. */
osg::ref_ptr<osg::Texture2D> createTexture(GLint internalFormat, GLenum format, GLenum type)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setInternalFormat(internalFormat);
    texture->setSourceFormat(format);
    texture->setSourceType(type);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    return texture;
}

/** The current frame buffer and viewport, for restoring them. */
class Destination
{
public:
    explicit Destination(const osg::State& state) : _extensions(*state.get<osg::GLExtensions>())
    {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &_frameBuffer);
        glGetIntegerv(GL_VIEWPORT, _viewport.data());
        glGetIntegerv(GL_SCISSOR_BOX, _scissor.data());
        glGetIntegerv(GL_SAMPLE_BUFFERS, &_sampleBuffers);
    }

    bool hasSamples() const { return _sampleBuffers > 0; }
    glm::ivec2 getOrigin() const { return {_viewport[0], _viewport[1]}; }
    glm::ivec2 getSize() const { return {_viewport[2], _viewport[3]}; }

    void restore() const
    {
        _extensions.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(_frameBuffer));
        glViewport(_viewport[0], _viewport[1], _viewport[2], _viewport[3]);
        glScissor(_scissor[0], _scissor[1], _scissor[2], _scissor[3]);
    }

private:
    const osg::GLExtensions& _extensions;
    GLint _frameBuffer = 0;
    std::array<GLint, 4> _viewport{};
    std::array<GLint, 4> _scissor{};
    GLint _sampleBuffers = 0;
};

/** Lets shaders read a buffer of bricks, during its lifetime. */
class BrickTexture
{
public:
    BrickTexture(osg::State& state, const GlTexture& texture, const DrawnBricks& bricks) : _state(state)
    {
        bind(texture.get());
        attach(bricks.buffer);
    }
    ~BrickTexture()
    {
        attach(0); // the texture would keep the memory of a buffer that is deleted later
        bind(0);
    }
    BrickTexture(const BrickTexture&) = delete;
    BrickTexture& operator=(const BrickTexture&) = delete;

private:
    void bind(GLuint texture) const
    {
        _state.setActiveTextureUnit(BRICKS_UNIT);
        glBindTexture(GL_TEXTURE_BUFFER, texture);
    }
    void attach(GLuint buffer) const
    {
        _state.get<osg::GLExtensions>()->glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, buffer);
    }

    osg::State& _state;
};

/** Apply a state set, and the matrix uniforms that OSG can set instead of the built-in matrices.
 * @return whether its program could be applied. */
bool applyState(osg::State& state, const osg::StateSet& stateSet)
{
    state.apply(&stateSet);
    if (!state.getLastAppliedProgramObject()) return false;
    if (state.getUseModelViewAndProjectionUniforms()) state.applyModelViewAndProjectionUniformsIfRequired();
    return true;
}

osg::ref_ptr<osg::StateSet> createPointState(const char* definitions)
{
    const osg::ref_ptr<osg::Program> program = ShaderLibrary::createProgram(
        "splats", {"polygonization/splats.vert", "polygonization/splats.frag"}, definitions);
    osg::ref_ptr<osg::StateSet> stateSet = createPassState(*program);
    stateSet->setAttributeAndModes(new osg::Depth(osg::Depth::LESS), osg::StateAttribute::ON | OVERRIDE_PROTECTED);
    setPointModes(*stateSet);
    return stateSet;
}

} // namespace

/** The textures into which the splats of all nodes in a context are drawn, one node after the other. */
class SplatTarget : public osg::Referenced
{
public:
    /** Whether splats are to be used on this renderer, and this target belongs to its context. */
    bool isFor(const osg::State& state, Drawing drawing)
    {
        // The owner may have been closed, together with its frame buffer object.
        if (!_owner.valid())
        {
            _owner = state.getGraphicsContext();
            _frameBuffer = nullptr;
            _size = glm::ivec2(0);
            _isSoftware = GlRequirements::getRenderer(state.getContextID()) == Renderer::SOFTWARE;
            std::array<GLfloat, 2> range{};
            glGetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range.data());
            _maximumPointSize = range[1];
            std::array<GLint, 2> viewport{};
            glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
            // See drawPoints.
            _maximumSize = {viewport[0] / 2, viewport[1]};
            _bricks = GlTexture();
            GLint texels = 0;
            glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
            _maximumBricks = texels / WORDS_PER_BRICK;
        }
        // Contexts that share objects would each need their own frame buffer objects.
        return (_isSoftware || drawing == Drawing::SPLATS) && !_hasFailed && _owner.get() == state.getGraphicsContext();
    }

    /** Stop using this target: a program or the frame buffer could not be created. */
    void fail() { _hasFailed = true; }

    float getMaximumPointSize() const { return _maximumPointSize; }
    GLsizei getMaximumBricks() const { return _maximumBricks; }
    /** Whether a picture of the given size in pixels is not empty and not too large. */
    bool isPossible(const glm::ivec2& size) const
    {
        return size.x > 0 && size.y > 0 && size.x <= _maximumSize.x && size.y <= _maximumSize.y;
    }
    osg::Texture2D& getSplats() const { return *_splats; }
    osg::Texture2D& getDepths() const { return *_depths; }
    /** The texture for the buffer of the bricks that are drawn. */
    const GlTexture& getBricks() const { return _bricks; }

    /** Bind the target for drawing, with at least the given size. */
    bool bind(osg::State& state, const glm::ivec2& size)
    {
        if (size.x > _size.x || size.y > _size.y) resize(glm::max(size, _size));
        if (_bricks.get() == 0) _bricks = GlTexture(state);
        // Create the textures on a unit known to the state; the frame buffer object would use any active unit.
        state.applyTextureAttribute(SPLATS_UNIT, _splats);
        state.applyTextureAttribute(DEPTHS_UNIT, _depths);
        _frameBuffer->apply(state, osg::FrameBufferObject::DRAW_FRAMEBUFFER);
        return isTargetThere(state);
    }

    /** Clear the depths of a picture of the given size in pixels. */
    void clearDepths(const glm::ivec2& size) const
    {
        glClearDepth(1.0);
        // Clearing a whole target is faster than clearing a part of the same size; the target may be larger than this
        // picture because of another node.
        const bool isPart = size != _size;
        if (isPart)
        {
            glEnable(GL_SCISSOR_TEST);
            glScissor(0, 0, size.x, size.y);
        }
        glClear(GL_DEPTH_BUFFER_BIT);
        if (isPart) glDisable(GL_SCISSOR_TEST);
    }

private:
    ~SplatTarget() override = default;

    void resize(const glm::ivec2& size)
    {
        _size = size;
        for (osg::Texture2D* texture : {_splats.get(), _depths.get()})
        {
            texture->setTextureSize(size.x, size.y);
            texture->dirtyTextureObject();
        }
        _frameBuffer = new osg::FrameBufferObject;
        _frameBuffer->setAttachment(osg::Camera::COLOR_BUFFER0, osg::FrameBufferAttachment(_splats));
        _frameBuffer->setAttachment(osg::Camera::DEPTH_BUFFER, osg::FrameBufferAttachment(_depths));
    }

    osg::observer_ptr<const osg::GraphicsContext> _owner;
    bool _isSoftware = false;
    bool _hasFailed = false;
    float _maximumPointSize = 1.0f;
    glm::ivec2 _maximumSize{0};
    glm::ivec2 _size{0};
    GlTexture _bricks;
    GLsizei _maximumBricks = 0;
    osg::ref_ptr<osg::Texture2D> _splats = createTexture(GL_R32UI, GL_RED_INTEGER_EXT, GL_UNSIGNED_INT);
    osg::ref_ptr<osg::Texture2D> _depths = createTexture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
    osg::ref_ptr<osg::FrameBufferObject> _frameBuffer;
};

namespace
{

/** Lets the nodes of a context share a target as long as one of them references it. */
class TargetOfContext : public osg::Referenced
{
public:
    explicit TargetOfContext(unsigned int) {}

    osg::ref_ptr<SplatTarget> get()
    {
        osg::ref_ptr<SplatTarget> target;
        if (_target.lock(target)) return target;
        target = new SplatTarget;
        _target = target;
        return target;
    }

private:
    ~TargetOfContext() override = default;

    osg::observer_ptr<SplatTarget> _target;
};

} // namespace

BrickSplats::BrickSplats(osg::StateSet& shading, osg::StateSet& shadingByOneLight, bool isPartial) :
    _boxes(createPointState(isPartial ? "#define PARTIAL\n" : "")),
    _studded(createPointState(isPartial ? "#define STUDS\n#define PARTIAL\n" : "#define STUDS\n")), _shading(&shading),
    _shadingByOneLight(&shadingByOneLight)
{
    for (const osg::ref_ptr<osg::StateSet>& stateSet : {_shading, _shadingByOneLight})
    {
        setPointModes(*stateSet);
        stateSet->addUniform(new osg::Uniform("splats", static_cast<int>(SPLATS_UNIT)));
        stateSet->addUniform(new osg::Uniform("splatDepths", static_cast<int>(DEPTHS_UNIT)));
        stateSet->addUniform(new osg::Uniform("splatBricks", static_cast<int>(BRICKS_UNIT)));
    }
}

BrickSplats::~BrickSplats() = default;

bool BrickSplats::draw(osg::State& state, const DrawnBricks& bricks, const BrickRanges& ranges, const CellView& view,
                       Drawing drawing, const DistantOcclusionView* distant) const
{
    osg::ref_ptr<SplatTarget>& held = _targets[state.getContextID()];
    if (!held) held = osg::get<TargetOfContext>(state.getContextID())->get();
    SplatTarget& target = *held;
    if (!view.isAllBehindNearPlane || !target.isFor(state, drawing)) return false;
    if (ranges.getAll().firsts.empty() && !bricks.blocks.empty()) return true;
    // Rays do not support other depth conventions.
    if (state.getLastAppliedAttribute(osg::StateAttribute::CLIPCONTROL)) return false;
    const Destination destination(state);
    if (!target.isPossible(destination.getSize()) || bricks.count > target.getMaximumBricks()) return false;
    if (bricks.ranks != 0 && bricks.count > MAXIMUM_PARTIAL) return false;
    const CellView::Rays rays = view.computeRays(destination.getSize());
    if (!view.areDistinct(rays) || !CellView::isDepthDistance(rays)) return false;
    const glm::vec2 largest = 0.5f * view.largestBrick * glm::vec2(destination.getSize());
    if (destination.hasSamples() || std::max(largest.x, largest.y) > target.getMaximumPointSize() - 1.0f) return false;

    const bool isReady = drawPoints(state, target, bricks, ranges, view, rays, destination.getSize());
    destination.restore();
    if (!isReady || !applyState(state, hasOneLight(state) ? *_shadingByOneLight : *_shading))
    {
        target.fail();
        return false;
    }
    state.applyTextureAttribute(SPLATS_UNIT, &target.getSplats());
    state.applyTextureAttribute(DEPTHS_UNIT, &target.getDepths());
    const BrickTexture texture(state, target.getBricks(), bricks);
    setBrickUniforms(state, bricks, view, false);
    if (distant) distant->apply(state);
    setRays(state, rays, destination.getSize());
    static const UniformName ORIGIN("origin");
    ProgramUniforms(state).set(ORIGIN, destination.getOrigin());
    drawTiles(state, bricks, ranges, view, destination.getSize());
    return true;
}

bool BrickSplats::drawPoints(osg::State& state, SplatTarget& target, const DrawnBricks& bricks,
                             const BrickRanges& ranges, const CellView& view, const CellView::Rays& rays,
                             const glm::ivec2& size) const
{
    const BrickGrid& grid = bricks.grid;
    bool isCleared = false;
    for (const bool hasStuds : {false, true})
    {
        const BrickRanges::Parts& parts = hasStuds ? ranges.getStudded() : ranges.getOthers();
        const bool isAll = hasStuds && bricks.blocks.empty();
        if (parts.firsts.empty() && !isAll) continue;
        if (!applyState(state, hasStuds ? *_studded : *_boxes)) return false;
        if (!isCleared && !target.bind(state, size)) return false;
        // The picture is the right half of the viewport, and points in the left half are outside the target. See
        // NOWHERE in splats.vert.
        glViewport(-size.x, 0, 2 * size.x, size.y);
        if (!isCleared) target.clearDepths(size);
        isCleared = true;
        setBrickUniforms(state, bricks, view, false);
        setRays(state, rays.onAxesOfStud(grid.getUpIndex()), size);
        drawBrickPoints(state, bricks, parts);
    }
    return true;
}

void BrickSplats::drawTiles(const osg::State& state, const DrawnBricks& bricks, const BrickRanges& ranges,
                            const CellView& view, const glm::ivec2& size) const
{
    PictureTiles& tiles = _tiles[state.getContextID()];
    tiles.clear(size);
    if (bricks.blocks.empty())
        tiles.add(view.area);
    else
        ranges.addTo(tiles, bricks.grid, view);
    tiles.findRuns();
    static const UniformName NUM_ACROSS("tilesAcross");
    static const UniformName SIDE("tileSide");
    const ProgramUniforms uniforms(state);
    uniforms.set(NUM_ACROSS, tiles.getNumAcross());
    uniforms.set(SIDE, static_cast<float>(PictureTiles::SIDE));
    state.get<osg::GLExtensions>()->glMultiDrawArrays(GL_POINTS, tiles.getFirsts().data(), tiles.getCounts().data(),
                                                      static_cast<GLsizei>(tiles.getFirsts().size()));
}

void BrickSplats::resizeGLObjectBuffers(unsigned int maxSize)
{
    _targets.resize(maxSize);
    _tiles.resize(maxSize);
    for (const osg::ref_ptr<osg::StateSet>& stateSet : {_boxes, _studded, _shading, _shadingByOneLight})
        stateSet->resizeGLObjectBuffers(maxSize);
}

void BrickSplats::releaseGLObjects(osg::State* state) const
{
    if (state)
        _targets[state->getContextID()] = nullptr;
    else
        _targets.setAllElementsTo(nullptr);
    for (const osg::ref_ptr<osg::StateSet>& stateSet : {_boxes, _studded, _shading, _shadingByOneLight})
        stateSet->releaseGLObjects(state);
}

} // namespace osgLego
