#include <osgLego/polygonization/BrickUniforms.h>

#include <osgLego/gl/ProgramUniforms.h>

#include <array>
#include <cstdint>

namespace osgLego
{

namespace
{

constexpr GLsizei BRICK_BYTES = 3 * sizeof(std::uint32_t);
constexpr int NUM_LIGHTS = 8;

/** The lights that a state has enabled. */
struct LightNumbers
{
    explicit LightNumbers(const osg::State& state)
    {
        for (int light = 0; light < NUM_LIGHTS; ++light)
            if (state.getLastAppliedMode(GL_LIGHT0 + static_cast<unsigned int>(light)))
                numbers[static_cast<std::size_t>(count++)] = light;
        if (!state.getLastAppliedMode(GL_LIGHTING)) count = -1;
    }

    std::array<int, NUM_LIGHTS> numbers{};
    int count = 0; // negative: lighting is off
};

/** Set the uniforms of the lights. */
void setLights(const ProgramUniforms& uniforms, const osg::State& state)
{
    const LightNumbers lights(state);
    static const UniformName NUMBER("numLights");
    static const UniformName NUMBERS("lightNumbers");
    uniforms.set(NUMBER, lights.count);
    uniforms.set(NUMBERS, lights.numbers.data(), NUM_LIGHTS);
}

} // namespace

void setBrickUniforms(const osg::State& state, const BrickGrid& grid, const CellView& view, bool showsInsides)
{
    static const UniformName UP_AXIS("upAxis");
    static const UniformName STUD_HEIGHT("studHeight");
    static const UniformName PROPORTIONS("cellProportions");
    static const UniformName EYE("eye");
    static const UniformName SHOWS_INSIDES("showsInsides");
    const ProgramUniforms uniforms(state);
    uniforms.set(UP_AXIS, grid.getUpIndex());
    uniforms.set(STUD_HEIGHT, static_cast<float>(grid.getStudHeight()));
    uniforms.set(PROPORTIONS, glm::vec3(grid.cellSize / grid.getPitch()));
    uniforms.set(EYE, view.eye);
    uniforms.set(SHOWS_INSIDES, showsInsides ? 1 : 0);
    setFog(uniforms, state);
    setLights(uniforms, state);
}

bool hasOneLight(const osg::State& state)
{
    return LightNumbers(state).count == 1;
}

void setRays(const osg::State& state, const CellView::Rays& rays, const glm::ivec2& pictureSize)
{
    static const UniformName ORIGIN("rayOrigin");
    static const UniformName DIRECTION("rayDirection");
    static const UniformName DEPTH("depth");
    static const UniformName SIZE("pictureSize");
    const ProgramUniforms uniforms(state);
    uniforms.set(ORIGIN, rays.origin);
    uniforms.set(DIRECTION, rays.direction);
    uniforms.set(DEPTH, glm::vec2(rays.depth.x, rays.depthSlope));
    uniforms.set(SIZE, glm::vec2(pictureSize));
}

void drawBrickPoints(osg::State& state, const ContextBricks& bricks, const BrickRanges::Parts& parts)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    extensions.glBindBuffer(GL_ARRAY_BUFFER, bricks.buffer.get());
    extensions.glEnableVertexAttribArray(0);
    extensions.glVertexAttribIPointer(0, 3, GL_UNSIGNED_INT, BRICK_BYTES, nullptr);
    if (bricks.blocks.empty())
        glDrawArrays(GL_POINTS, 0, bricks.numBricks);
    else
        extensions.glMultiDrawArrays(GL_POINTS, parts.firsts.data(), parts.counts.data(),
                                     static_cast<GLsizei>(parts.firsts.size()));
    extensions.glDisableVertexAttribArray(0);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

} // namespace osgLego
