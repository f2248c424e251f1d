#include <osgLego/polygonization/SplatTarget.h>

#include <osgLego/gl/GlRequirements.h>
#include <osgLego/gl/PassState.h>
#include <osgLego/polygonization/BrickStates.h>

#include <algorithm>
#include <bit>

#include <osg/ContextData>
#include <osg/Depth>
#include <osg/FrameStamp>
#include <osgUtil/RenderLeaf>
#include <osgUtil/StateGraph>

namespace osgLego
{

namespace
{

constexpr GLsizei WORDS_PER_BRICK = 3;
// The numbers of bricks that splats can distinguish; see splat_rays.glsl.
constexpr GLsizei MAXIMUM_SPLATS = 1 << 30;

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
    // OSG's default does not exist in the core profile.
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return texture;
}

/** The targets of a context and of those that share its objects, which nodes own. */
class TargetsOfContext : public osg::Referenced
{
public:
    explicit TargetsOfContext(unsigned int) {}

    std::vector<osg::observer_ptr<SplatTarget>> targets;

private:
    ~TargetsOfContext() override = default;
};

/** A hash of the drawables in a bin and of their places. */
std::uint64_t hashContents(const osgUtil::RenderBin& bin)
{
    std::uint64_t hash = 0;
    const auto add = [&hash](std::uint64_t value) { hash = (hash ^ value) * 0x9e3779b97f4a7c15ull + (hash >> 29); };
    const auto addLeaf = [&add](const osgUtil::RenderLeaf& leaf)
    {
        add(reinterpret_cast<std::uintptr_t>(leaf._drawable.get()));
        if (!leaf._modelview) return;
        for (int element = 0; element < 16; ++element)
            add(std::bit_cast<std::uint64_t>(leaf._modelview->ptr()[element]));
    };
    for (const osgUtil::StateGraph* graph : bin.getStateGraphList())
        for (const osg::ref_ptr<osgUtil::RenderLeaf>& leaf : graph->_leaves)
            addLeaf(*leaf);
    for (const osgUtil::RenderLeaf* leaf : bin.getRenderLeafList())
        addLeaf(*leaf);
    return hash;
}

} // namespace

SplatDestination::SplatDestination(const osg::State& state) :
    _extensions(*state.get<osg::GLExtensions>()), _isScissored(state.getLastAppliedMode(GL_SCISSOR_TEST))
{
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &_frameBuffer);
    glGetIntegerv(GL_VIEWPORT, _viewport.data());
    glGetIntegerv(GL_SCISSOR_BOX, _scissor.data());
    glGetIntegerv(GL_SAMPLE_BUFFERS, &_sampleBuffers);
}

void SplatDestination::restore() const
{
    _extensions.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(_frameBuffer));
    glViewport(_viewport[0], _viewport[1], _viewport[2], _viewport[3]);
    glScissor(_scissor[0], _scissor[1], _scissor[2], _scissor[3]);
    if (!_isScissored) glDisable(GL_SCISSOR_TEST);
}

void SplatDestination::clipPoints() const
{
    glm::ivec2 lower(_viewport[0], _viewport[1]);
    glm::ivec2 upper = lower + glm::ivec2(_viewport[2], _viewport[3]);
    if (_isScissored)
    {
        const glm::ivec2 corner(_scissor[0], _scissor[1]);
        lower = glm::max(lower, corner);
        upper = glm::min(upper, corner + glm::ivec2(_scissor[2], _scissor[3]));
    }
    const glm::ivec2 size = glm::max(upper - lower, 0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(lower.x, lower.y, size.x, size.y);
}

std::optional<SplatPicture> SplatPicture::find(osg::RenderInfo& renderInfo, const SplatDestination& destination)
{
    const osg::State& state = *renderInfo.getState();
    const osg::FrameStamp* frameStamp = state.getFrameStamp();
    const osg::RenderInfo::RenderBinStack& bins = renderInfo.getRenderBinStack();
    if (!frameStamp || bins.empty() || state.getLastAppliedMode(GL_SCISSOR_TEST)) return std::nullopt;
    // In bins with another order, programs may draw a surface between two nodes that moves depths away for the second.
    if (bins.back()->getSortMode() != osgUtil::RenderBin::SORT_BY_STATE) return std::nullopt;
    SplatPicture picture;
    picture.bin = bins.back();
    picture.frame = frameStamp->getFrameNumber();
    picture.frameBuffer = destination.getFrameBuffer();
    picture.origin = destination.getOrigin();
    picture.size = destination.getSize();
    picture.view = state.getInitialViewMatrix();
    picture.projection = state.getProjectionMatrix();
    const auto* depth = dynamic_cast<const osg::Depth*>(state.getLastAppliedAttribute(osg::StateAttribute::DEPTH));
    if (!depth) return picture;
    // With other functions, equally distant bricks of a later node replace those of a previous one.
    if (depth->getFunction() != osg::Depth::LESS) return std::nullopt;
    picture.depthRange = {depth->getZNear(), depth->getZFar()};
    return picture;
}

SplatTarget::SplatTarget(const osg::State& state) :
    _owner(&state), _splats(createTexture(GL_R32UI, GL_RED_INTEGER_EXT, GL_UNSIGNED_INT)),
    _depths(createTexture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT)),
    _frameBuffer(new osg::FrameBufferObject)
{
    std::array<GLfloat, 2> range{};
    // In the core profile, GL_POINT_SIZE_RANGE has replaced the others, and the value of the one for smooth points.
    glGetFloatv(GlRequirements::isCore(state) ? GL_SMOOTH_POINT_SIZE_RANGE : GL_ALIASED_POINT_SIZE_RANGE, range.data());
    _maximumPointSize = range[1];
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    // The viewport for points is twice as wide as the picture; see bind().
    _maximumSize = {viewport[0] / 2, viewport[1]};
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    _maximumBricks = texels / WORDS_PER_BRICK;
}

SplatTarget::~SplatTarget() = default;

void SplatTarget::fail()
{
    if (!_hasFailed)
        OSG_WARN << "osgLego: splats can't be drawn in this context; triangles are drawn instead, which takes longer"
                 << std::endl;
    _hasFailed = true;
}

osg::ref_ptr<SplatTarget> SplatTarget::get(const osg::State& state)
{
    auto& targets = osg::get<TargetsOfContext>(state.getContextID())->targets;
    std::erase_if(targets, [](const osg::observer_ptr<SplatTarget>& target) { return !target.valid(); });
    osg::ref_ptr<SplatTarget> found;
    for (const osg::observer_ptr<SplatTarget>& target : targets)
        if (target.lock(found) && found->belongsTo(state)) return found;
    found = new SplatTarget(state);
    targets.emplace_back(found);
    return found;
}

SplatJob* SplatTarget::find(const std::optional<SplatPicture>& picture, const BrickDrawable& node,
                            const osg::Matrixd& modelView)
{
    if (!picture || _picture != picture) return nullptr;
    // Nodes are usually drawn in the order of their jobs.
    for (std::size_t offset = 0; offset < _numJobs; ++offset)
    {
        const std::size_t index = (_nextJob + offset) % _numJobs;
        SplatJob& job = _jobs[index];
        if (job.node != &node || job.isShaded || job.modelView != modelView) continue;
        _nextJob = index + 1;
        return &job;
    }
    return nullptr;
}

std::size_t SplatTarget::begin(const std::optional<SplatPicture>& picture, const BrickDrawable& node,
                               const osg::Matrixd& modelView)
{
    // The frame number does not change if a frame is drawn again, with the same nodes or with others.
    const std::uint64_t contents = picture ? hashContents(*picture->bin) : 0;
    const auto last = _jobs.begin() + static_cast<std::ptrdiff_t>(_numJobs);
    const bool isAgain = std::any_of(
        _jobs.begin(), last, [&](const SplatJob& job) { return job.node == &node && job.modelView == modelView; });
    if (!picture || _picture != picture || _contents != contents || isAgain)
    {
        _numJobs = 0;
        _numSplats = 0;
        _isCleared = false;
    }
    _picture = picture;
    _contents = contents;
    _nextJob = _numJobs;
    return _numJobs;
}

SplatJob& SplatTarget::addJob()
{
    if (_numJobs == _jobs.size()) _jobs.emplace_back();
    return _jobs[_numJobs++];
}

bool SplatTarget::number(SplatJob& job, GLsizei count)
{
    if (count > MAXIMUM_SPLATS - _numSplats) return false;
    job.firstSplat = _numSplats;
    job.numSplats = count;
    _numSplats += count;
    return true;
}

bool SplatTarget::bind(osg::State& state, const glm::ivec2& size)
{
    if (size.x > _size.x || size.y > _size.y) resize(glm::max(size, _size));
    if (_bricks.get() == 0) _bricks = GlTexture(state);
    // Create the textures on a unit known to the state; the frame buffer object would use any active unit.
    state.applyTextureAttribute(BrickStates::SPLATS_UNIT, _splats);
    state.applyTextureAttribute(BrickStates::DEPTHS_UNIT, _depths);
    _frameBuffer->apply(state, osg::FrameBufferObject::DRAW_FRAMEBUFFER);
    setPointViewport(size);
    if (!isTargetThere(state)) return false;
    if (!_isCleared) clearDepths(size);
    _isCleared = true;
    return true;
}

void SplatTarget::clearDepths(const glm::ivec2& size) const
{
    glClearDepth(1.0);
    // Clearing a whole target is faster than clearing a part of the same size; the target may be larger than this
    // picture because of another one.
    const bool isPart = size != _size;
    if (isPart)
    {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, size.x, size.y);
    }
    glClear(GL_DEPTH_BUFFER_BIT);
    if (isPart) glDisable(GL_SCISSOR_TEST);
}

void SplatTarget::resize(const glm::ivec2& size)
{
    _size = size;
    for (osg::Texture2D* texture : {_splats.get(), _depths.get()})
    {
        texture->setTextureSize(size.x, size.y);
        texture->dirtyTextureObject();
    }
    // Not a new object: the name of the old one might be deleted in a context that shares objects with this one.
    _frameBuffer->setAttachment(osg::Camera::COLOR_BUFFER0, osg::FrameBufferAttachment(_splats));
    _frameBuffer->setAttachment(osg::Camera::DEPTH_BUFFER, osg::FrameBufferAttachment(_depths));
}

} // namespace osgLego
