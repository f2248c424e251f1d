#include <osgLego/BrickUniforms.h>

#include <osgLego/ProgramUniforms.h>

#include <array>
#include <cstdint>

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

void setBrickUniforms(const osg::State& state, const BrickGrid& grid, const CellView& view)
{
    const ProgramUniforms uniforms(state);
    const int up = grid.getUpIndex();
    uniforms.set("upAxis", up);
    uniforms.set("studHeight", static_cast<float>(BrickGrid::STUD_HEIGHT * grid.getPitch() / grid.cellSize[up]));
    uniforms.set("cellProportions", glm::vec3(grid.cellSize / grid.getPitch()));
    uniforms.set("eye", view.eye);
    uniforms.set("nearPlane", view.nearPlane);
    uniforms.set("isMirrored", view.isMirrored ? 1 : 0);
    setFog(uniforms, state);
    setLights(uniforms, state);
}

void setRays(const osg::State& state, const CellView& view, const glm::ivec2& pictureSize)
{
    const ProgramUniforms uniforms(state);
    const CellView::Rays rays = view.computeRays(pictureSize);
    uniforms.set("rayOrigin", rays.origin);
    uniforms.set("rayDirection", rays.direction);
    uniforms.set("pictureSize", glm::vec2(pictureSize));
}

void drawBrickPoints(osg::State& state, const ContextBricks& bricks)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    extensions.glBindBuffer(GL_ARRAY_BUFFER, bricks.buffer.get());
    extensions.glEnableVertexAttribArray(0);
    extensions.glVertexAttribIPointer(0, 3, GL_UNSIGNED_INT, BRICK_BYTES, nullptr);
    glDrawArrays(GL_POINTS, 0, bricks.numBricks);
    extensions.glDisableVertexAttribArray(0);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

} // namespace osgLego
