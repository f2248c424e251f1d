#include <osgLego/store/PartialOcclusion.h>

#include <osgLego/data/BrickNeighbors.h>

#include <cstddef>
#include <utility>
#include <vector>

#include <osg/GLExtensions>

namespace osgLego
{

namespace
{

GlBuffer createTextureBuffer(const osg::State& state, std::size_t numBytes, const void* data, GLenum usage)
{
    GlBuffer buffer(state);
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindBuffer(GL_TEXTURE_BUFFER, buffer.get());
    extensions.glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(numBytes), data, usage);
    extensions.glBindBuffer(GL_TEXTURE_BUFFER, 0);
    return buffer;
}

} // namespace

PartialOcclusion::PartialOcclusion(const osg::State& state, const BuildingSet& building) : _ranks(state)
{
    const std::vector<std::uint32_t> ranks = building.createRankBlocks();
    _rankBuffer = createTextureBuffer(state, ranks.size() * sizeof(ranks[0]), ranks.data(), GL_STATIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, _ranks.get());
    state.get<osg::GLExtensions>()->glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, _rankBuffer.get());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    const std::size_t count = building.getPoints().points.size();
    GlBuffer neighbors = createTextureBuffer(state, count * sizeof(BrickNeighbors), nullptr, GL_DYNAMIC_COPY);
    _textures = new GridOcclusionTextures(state, building.getModel().getGrid(), std::move(neighbors),
                                          static_cast<GLsizei>(count));
}

} // namespace osgLego
