#include <osgLego/polygonization/BrickUniforms.h>

#include <osgLego/gl/CoreVertexArray.h>
#include <osgLego/gl/FixedState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/polygonization/LightNumbers.h>

#include <cstddef>
#include <cstdint>

namespace osgLego
{

namespace
{

/** Set the uniforms of the lights. */
void setLights(const ProgramUniforms& uniforms, const osg::State& state)
{
    const LightNumbers lights(state);
    static const UniformName NUMBER("numLights");
    static const UniformName NUMBERS("lightNumbers");
    uniforms.set(NUMBER, lights.count);
    uniforms.set(NUMBERS, lights.numbers.data(), LightNumbers::MAXIMUM);
}

/** Set the uniforms of lines, of shaders/polygonization/part_lines.glsl. */
void setLines(const ProgramUniforms& uniforms, const BrickLines& lines)
{
    static const UniformName WIDTH("lineWidth");
    static const UniformName OLD_WIDTH("oldLineWidth");
    static const UniformName PIXEL_WIDTH("linePixelWidth");
    uniforms.set(WIDTH, lines.width);
    uniforms.set(OLD_WIDTH, lines.oldWidth);
    uniforms.set(PIXEL_WIDTH, lines.pixelWidth);
}

/** Let a vertex attribute read a member of the items in the bound buffer. */
void setAttribute(const osg::GLExtensions& extensions, GLuint location, GLint count, std::size_t stride,
                  std::size_t offset)
{
    extensions.glEnableVertexAttribArray(location);
    extensions.glVertexAttribIPointer(location, count, GL_UNSIGNED_INT, static_cast<GLsizei>(stride),
                                      reinterpret_cast<const void*>(offset));
}

/** Set the attributes of the vertex shaders, and return their number. */
GLuint setAttributes(const osg::GLExtensions& extensions, const DrawnBricks& bricks)
{
    extensions.glBindBuffer(GL_ARRAY_BUFFER, bricks.buffer);
    setAttribute(extensions, 0, 3, sizeof(BrickPoint), 0);
    if (bricks.ranks == 0) return 1;
    extensions.glBindBuffer(GL_ARRAY_BUFFER, bricks.ranks);
    setAttribute(extensions, 1, 1, sizeof(CellRanks), offsetof(CellRanks, own));
    setAttribute(extensions, 2, 3, sizeof(CellRanks), offsetof(CellRanks, lower));
    setAttribute(extensions, 3, 3, sizeof(CellRanks), offsetof(CellRanks, upper));
    return 4;
}

/** Draw points with the attributes of the vertex shaders set. @param draw calls GL. */
template <typename Draw>
void drawWithAttributes(osg::State& state, const DrawnBricks& bricks, const Draw& draw)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    const CoreVertexArray vertexArray(state);
    const GLuint numAttributes = setAttributes(extensions, bricks);
    draw(extensions);
    for (GLuint location = 0; location < numAttributes; ++location)
        extensions.glDisableVertexAttribArray(location);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

} // namespace

void setPartUniforms(const osg::State& state, const DrawnBricks& bricks)
{
    static const UniformName NUM_PLACED("numPlaced");
    static const UniformName NUM_OLD("numOld");
    const ProgramUniforms uniforms(state);
    uniforms.set(NUM_PLACED, static_cast<int>(bricks.numPlaced));
    uniforms.set(NUM_OLD, static_cast<int>(bricks.numOld));
}

void setBrickUniforms(const osg::State& state, const DrawnBricks& bricks, const CellView& view, Faces faces)
{
    static const UniformName UP_AXIS("upAxis");
    static const UniformName STUD_HEIGHT("studHeight");
    static const UniformName PROPORTIONS("cellProportions");
    static const UniformName EYE("eye");
    static const UniformName DRAWN_FACES("drawnFaces");
    const ProgramUniforms uniforms(state);
    const BrickGrid& grid = bricks.grid;
    uniforms.set(UP_AXIS, grid.getUpIndex());
    uniforms.set(STUD_HEIGHT, static_cast<float>(grid.getStudHeight()));
    uniforms.set(PROPORTIONS, glm::vec3(grid.cellSize / grid.getPitch()));
    uniforms.set(EYE, view.eye);
    uniforms.set(DRAWN_FACES, static_cast<int>(faces));
    if (bricks.ranks != 0) setPartUniforms(state, bricks);
    setLines(uniforms, bricks.lines);
    setFog(uniforms, state);
    setMatrices(uniforms, state);
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
    static const UniformName WEIGHT("rayWeight");
    static const UniformName DEPTH("depth");
    static const UniformName SIZE("pictureSize");
    const ProgramUniforms uniforms(state);
    uniforms.set(ORIGIN, rays.origin);
    uniforms.set(DIRECTION, rays.direction);
    uniforms.set(WEIGHT, rays.weight);
    uniforms.set(DEPTH, glm::vec2(rays.depth.x, rays.depthSlope));
    uniforms.set(SIZE, glm::vec2(pictureSize));
}

void setDepthConversion(const osg::State& state, const DepthConversion& conversion)
{
    static const UniformName RANGE("depthRange");
    static const UniformName OFFSET("depthOffset");
    const ProgramUniforms uniforms(state);
    uniforms.set(RANGE, conversion.range);
    uniforms.set(OFFSET, conversion.offset);
}

void drawBrickPoints(osg::State& state, const DrawnBricks& bricks, const BrickRanges::Parts& parts)
{
    if (bricks.blocks.empty())
        drawAllBrickPoints(state, bricks);
    else
        drawWithAttributes(state, bricks,
                           [&](const osg::GLExtensions& extensions)
                           {
                               extensions.glMultiDrawArrays(GL_POINTS, parts.firsts.data(), parts.counts.data(),
                                                            static_cast<GLsizei>(parts.firsts.size()));
                           });
}

void drawAllBrickPoints(osg::State& state, const DrawnBricks& bricks)
{
    drawWithAttributes(state, bricks, [&](const osg::GLExtensions&) { glDrawArrays(GL_POINTS, 0, bricks.count); });
}

} // namespace osgLego
