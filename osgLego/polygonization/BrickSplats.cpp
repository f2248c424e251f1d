#include <osgLego/polygonization/BrickSplats.h>

#include <osgLego/gl/CoreVertexArray.h>
#include <osgLego/gl/GlObject.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/polygonization/BrickUniforms.h>
#include <osgLego/polygonization/FittedTiles.h>

#include <algorithm>

namespace osgLego
{

namespace
{

// The number of bricks that the splats of a partly built model can distinguish; see splat_rays.glsl.
constexpr GLsizei MAXIMUM_PARTIAL = 1 << 23;

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
        _state.setActiveTextureUnit(BrickStates::BRICKS_UNIT);
        glBindTexture(GL_TEXTURE_BUFFER, texture);
    }
    void attach(GLuint buffer) const
    {
        _state.get<osg::GLExtensions>()->glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, buffer);
    }

    osg::State& _state;
};

} // namespace

bool applyBrickState(osg::State& state, const osg::StateSet& stateSet)
{
    state.apply(&stateSet);
    if (!state.getLastAppliedProgramObject()) return false;
    if (state.getUseModelViewAndProjectionUniforms()) state.applyModelViewAndProjectionUniformsIfRequired();
    return true;
}

BrickSplats::BrickSplats(const BrickStates& states) : _states(&states) {}

BrickSplats::~BrickSplats() = default;

SplatTarget& BrickSplats::getTarget(const osg::State& state) const
{
    std::vector<osg::ref_ptr<SplatTarget>>& targets = _targets[state.getContextID()];
    for (const osg::ref_ptr<SplatTarget>& target : targets)
        if (target->belongsTo(state)) return *target;
    std::erase_if(targets, [](const osg::ref_ptr<SplatTarget>& target) { return target->isAbandoned(); });
    return *targets.emplace_back(SplatTarget::get(state));
}

/** Find the rays of a picture. @return whether bricks can be drawn as points. */
bool BrickSplats::findRays(const osg::State& state, const SplatDestination& destination, const CellView& view,
                           CellView::Rays& rays) const
{
    const SplatTarget& target = getTarget(state);
    // Rays do not support other depth conventions.
    if (!view.isAllBehindNearPlane || state.getLastAppliedAttribute(osg::StateAttribute::CLIPCONTROL)) return false;
    if (!target.isPossible(destination.getSize()) || destination.hasSamples()) return false;
    rays = view.computeRays(destination.getSize());
    if (!view.areDistinct(rays, destination.getSize()) || !CellView::isDepthDistance(rays)) return false;
    if (!CellView::areWeightsPositive(rays, destination.getSize())) return false;
    const glm::vec2 largest = 0.5f * view.largestBrick * glm::vec2(destination.getSize());
    return std::max(largest.x, largest.y) <= target.getMaximumPointSize() - 1.0f;
}

bool BrickSplats::prepare(const osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                          SplatJob& job) const
{
    SplatTarget& target = getTarget(state);
    if (bricks.count > target.getMaximumBricks()) return false;
    if (bricks.ranks != 0 && bricks.count > MAXIMUM_PARTIAL) return false;
    if (!findRays(state, destination, *job.view, job.rays) || !job.rays.isLinear()) return false;
    job.buffer = bricks.buffer;
    job.blocks = bricks.blocks.data();
    return target.number(job, bricks.count);
}

bool BrickSplats::hasPoints(const DrawnBricks& bricks, const SplatJob& job, bool hasStuds)
{
    // While the blocks are unknown, all bricks may have visible studs.
    return bricks.blocks.empty() ? hasStuds
                                 : !(hasStuds ? job.ranges.getStudded() : job.ranges.getOthers()).firsts.empty();
}

void BrickSplats::drawPoints(osg::State& state, const DrawnBricks& bricks, const SplatJob& job, bool hasStuds,
                             const glm::ivec2& size)
{
    static const UniformName FIRST("firstSplat");
    setBrickUniforms(state, bricks, *job.view, Faces::FRONT);
    setRays(state, job.rays.onAxesOfStud(bricks.grid.getUpIndex()), size);
    ProgramUniforms(state).set(FIRST, job.firstSplat);
    drawBrickPoints(state, bricks, hasStuds ? job.ranges.getStudded() : job.ranges.getOthers());
}

bool BrickSplats::shade(osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                        const SplatJob& job, const BrickLight& light) const
{
    static const UniformName ORIGIN("origin");
    static const UniformName FIRST("firstSplat");
    static const UniformName COUNT("numSplats");
    if (job.ranges.getAll().firsts.empty() && !bricks.blocks.empty()) return true;
    SplatTarget& target = getTarget(state);
    const BrickStates::Shading shading = _states->getShading(!light.shadows.isEmpty());
    if (!applyBrickState(state, hasOneLight(state) ? *shading.splatsByOneLight : *shading.splats))
    {
        target.fail();
        return false;
    }
    state.applyTextureAttribute(BrickStates::SPLATS_UNIT, &target.getSplats());
    state.applyTextureAttribute(BrickStates::DEPTHS_UNIT, &target.getDepths());
    const BrickTexture texture(state, target.getBricks(), bricks);
    setBrickUniforms(state, bricks, *job.view, Faces::FRONT);
    light.apply(state);
    setRays(state, job.rays, destination.getSize());
    const ProgramUniforms uniforms(state);
    uniforms.set(ORIGIN, destination.getOrigin());
    uniforms.set(FIRST, job.firstSplat);
    uniforms.set(COUNT, job.numSplats);
    drawTiles(state, bricks, job.ranges, *job.view, destination.getSize());
    return true;
}

bool BrickSplats::drawDepths(osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                             const DepthJob& job) const
{
    CellView::Rays rays;
    if (job.faces == Faces::ALL || destination.getOrigin() != glm::ivec2(0)) return false;
    if (!findRays(state, destination, job.view, rays)) return false;
    const DepthConversion conversion(state);
    const glm::ivec2 size = destination.getSize();
    SplatTarget::setPointViewport(size);
    bool isDrawn = true;
    for (const bool hasStuds : {false, true})
    {
        const BrickRanges::Parts& parts = hasStuds ? job.ranges.getStudded() : job.ranges.getOthers();
        if (bricks.blocks.empty() ? !hasStuds : parts.firsts.empty()) continue;
        isDrawn = applyBrickState(state, _states->getDepthPoints(job.faces, hasStuds));
        if (!isDrawn) break;
        setBrickUniforms(state, bricks, job.view, job.faces);
        setRays(state, rays.onAxesOfStud(bricks.grid.getUpIndex()), size);
        setDepthConversion(state, conversion);
        destination.clipPoints();
        drawBrickPoints(state, bricks, parts);
    }
    destination.restore();
    return isDrawn;
}

void BrickSplats::drawTiles(const osg::State& state, const DrawnBricks& bricks, const BrickRanges& ranges,
                            const CellView& view, const glm::ivec2& size) const
{
    static const UniformName FIRST("firstPixel");
    static const UniformName NUM_ACROSS("tilesAcross");
    static const UniformName SIDE("tileSide");
    const ProgramUniforms uniforms(state);
    const CoreVertexArray vertexArray(state);
    if (FittedTiles::isSmall(view.area, size))
    {
        const FittedTiles tiles = FittedTiles::fit(view.area, size);
        uniforms.set(FIRST, tiles.first);
        uniforms.set(NUM_ACROSS, tiles.count.x);
        uniforms.set(SIDE, static_cast<float>(tiles.side));
        const GLint first = 0;
        const GLsizei count = tiles.count.x * tiles.count.y;
        state.get<osg::GLExtensions>()->glMultiDrawArrays(GL_POINTS, &first, &count, 1);
        return;
    }
    PictureTiles& tiles = _tiles[state.getContextID()];
    tiles.clear(size);
    if (bricks.blocks.empty())
        tiles.add(view.area);
    else
        ranges.addTo(tiles, bricks.grid, view);
    tiles.findRuns();
    uniforms.set(FIRST, glm::ivec2(0));
    uniforms.set(NUM_ACROSS, tiles.getNumAcross());
    uniforms.set(SIDE, static_cast<float>(PictureTiles::SIDE));
    state.get<osg::GLExtensions>()->glMultiDrawArrays(GL_POINTS, tiles.getFirsts().data(), tiles.getCounts().data(),
                                                      static_cast<GLsizei>(tiles.getFirsts().size()));
}

void BrickSplats::resizeGLObjectBuffers(unsigned int maxSize)
{
    _targets.resize(maxSize);
    _tiles.resize(maxSize);
}

void BrickSplats::releaseGLObjects(osg::State* state) const
{
    if (state)
        _targets[state->getContextID()].clear();
    else
        _targets.setAllElementsTo({});
}

} // namespace osgLego
