#include <osgLego/BrickDrawable.h>

#include <osgLego/BrickGeometry.h>
#include <osgLego/ProgramUniforms.h>

#include <array>
#include <cstdint>

#include <osg/RenderInfo>

namespace osgLego
{

namespace
{

constexpr GLsizei BRICK_BYTES = 3 * sizeof(std::uint32_t);
constexpr int NUM_LIGHTS = 8;

/** Tell the program which lights the state has switched on. */
void setLights(const ProgramUniforms& uniforms, const osg::State& state)
{
    std::array<int, NUM_LIGHTS> numbers{};
    int count = 0;
    for (int light = 0; light < NUM_LIGHTS; ++light)
        if (state.getLastAppliedMode(GL_LIGHT0 + static_cast<unsigned int>(light)))
            numbers[static_cast<std::size_t>(count++)] = light;
    uniforms.set("numLights", state.getLastAppliedMode(GL_LIGHTING) ? count : -1);
    uniforms.set("lightNumbers", numbers.data(), NUM_LIGHTS);
}

} // namespace

BrickDrawable::BrickDrawable(BrickStore& store) : _store(&store)
{
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setDataVariance(osg::Object::STATIC);
}

osg::BoundingBox BrickDrawable::computeBoundingBox() const
{
    const osg::ref_ptr<const LegoSource> source = _store->getSource();
    if (!source) return {};
    const osg::BoundingBoxd bounds = source->triangles->getGrid().getBrickBounds();
    if (!bounds.valid()) return {};
    return {osg::Vec3(bounds._min), osg::Vec3(bounds._max)};
}

void BrickDrawable::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    const osg::ref_ptr<ContextBricks> bricks = _store->getContext(state.getContextID());
    const std::lock_guard lock(bricks->getMutex());
    if (bricks->numBricks == 0 || !state.getLastAppliedProgramObject()) return;

    // The bricks are in cells; their way to the eye is put together in double precision, so that models far from the
    // origin of their coordinates do not shake.
    const BrickGrid& grid = bricks->source->triangles->getGrid();
    const osg::ref_ptr<const osg::RefMatrix> modelView = new osg::RefMatrix(state.getModelViewMatrix());
    state.applyModelViewMatrix(new osg::RefMatrix(grid.getCellsToModel() * *modelView));
    if (state.getUseModelViewAndProjectionUniforms()) state.applyModelViewAndProjectionUniformsIfRequired();

    const ProgramUniforms uniforms(state);
    const int up = grid.getUpIndex();
    uniforms.set("upAxis", up);
    uniforms.set("studHeight", static_cast<float>(BrickGrid::STUD_HEIGHT * grid.getPitch() / grid.cellSize[up]));
    uniforms.set("cellProportions", glm::vec3(grid.cellSize / grid.getPitch()));
    setFog(uniforms, state);
    setLights(uniforms, state);

    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    extensions.glBindBuffer(GL_ARRAY_BUFFER, bricks->buffer.get());
    extensions.glEnableVertexAttribArray(0);
    extensions.glVertexAttribIPointer(0, 3, GL_UNSIGNED_INT, BRICK_BYTES, nullptr);
    glDrawArrays(GL_POINTS, 0, bricks->numBricks);
    extensions.glDisableVertexAttribArray(0);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);

    state.applyModelViewMatrix(modelView.get());
}

void BrickDrawable::accept(osg::PrimitiveFunctor& functor) const
{
    if (const osg::ref_ptr<const BrickModel> model = _store->getModel()) acceptBrickFaces(*model, functor);
}

void BrickDrawable::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    _store->releaseGLObjects(state);
}

} // namespace osgLego
