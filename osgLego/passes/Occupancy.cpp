#include <osgLego/passes/Occupancy.h>

#include <osgLego/data/BrickPoints.h>
#include <osgLego/gl/ProgramUniforms.h>

#include <cstdint>
#include <vector>

namespace osgLego
{

namespace
{

constexpr GLuint IMAGE_UNIT = 0;

int countAlong(int begin, int end)
{
    constexpr int SIDE = BrickPoints::BLOCK_SIDE;
    return (end - 1) / SIDE - begin / SIDE + 1;
}

} // namespace

int Occupancy::countBlocks(const BrickGrid& grid, const Slab& slab)
{
    return countAlong(0, grid.dimensions.x) * countAlong(0, grid.dimensions.y) *
           countAlong(slab.imageBegin, slab.imageEnd);
}

void Occupancy::clear(const osg::State& state, int numBlocks)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    if (_buffer.get() == 0) _buffer = GlBuffer(state);
    if (_texture.get() == 0) _texture = GlTexture(state);
    const std::vector<std::uint32_t> words(static_cast<std::size_t>(numBlocks) * WORDS_PER_BLOCK);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, _buffer.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(words.size() * sizeof(std::uint32_t)),
                            words.data(), GL_DYNAMIC_COPY);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindTexture(GL_TEXTURE_BUFFER, _texture.get());
    extensions.glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, _buffer.get());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    _isMarked = false;
}

void Occupancy::beginMarking(osg::State& state)
{
    // Depends on whether the shader compiler supports images, not on the version or extensions that the driver reports.
    const ProgramUniforms uniforms(state);
    _isMarked = uniforms.has("occupancy");
    if (!_isMarked) return;
    uniforms.set("occupancy", static_cast<int>(IMAGE_UNIT));
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindImageTexture(IMAGE_UNIT, _texture.get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    state.haveAppliedAttribute(osg::StateAttribute::BINDIMAGETEXTURE, IMAGE_UNIT);
}

void Occupancy::endMarking(osg::State& state) const
{
    if (!_isMarked) return;
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                               GL_BUFFER_UPDATE_BARRIER_BIT);
    extensions.glBindImageTexture(IMAGE_UNIT, 0, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
}

} // namespace osgLego
