#include <osgLego/store/GridOcclusionTextures.h>

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/data/OcclusionTable.h>
#include <osgLego/data/SharedObjects.h>
#include <osgLego/data/StudOcclusion.h>
#include <osgLego/gl/SharedBetweenViewers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include <osg/GLExtensions>

namespace osgLego
{

namespace
{

/** Creates the image of a table for cells of a height and a radius, in pitches. */
using CreateImage = osg::ref_ptr<osg::Image> (*)(double height, double radius);

// The heights of cells, in pitches, between which tables are exact: the time to create one grows with the number of
// cells within the radius, and stored bricks may be as flat as a file says.
constexpr double LEAST_HEIGHT = 0.1;
constexpr double MOST_HEIGHT = 10.0;
constexpr double HEIGHT_STEP = 1e-6; // heights that differ by rounding alone share a table

/** The image of a table. The one asked for last is kept, since a viewer that opens after the last one has closed
 * usually shows cells of the same height. */
osg::ref_ptr<osg::Image> getImage(CreateImage create, double height)
{
    static SharedObjects<std::pair<CreateImage, double>, osg::Image> images;
    static std::mutex mutex;
    static std::map<CreateImage, osg::ref_ptr<osg::Image>> kept;
    const auto createImage = [=]
    {
        osg::ref_ptr<osg::Image> image = create(height, AmbientOcclusionSettings::RADIUS_IN_BRICKS);
        // Prevents OSG from dropping the image once it is loaded, since other contexts may need it later.
        image->setDataVariance(osg::Object::DYNAMIC);
        return image;
    };
    osg::ref_ptr<osg::Image> image = images.findOrCreate({create, height}, createImage);
    const std::lock_guard lock(mutex);
    kept[create] = image;
    return image;
}

osg::ref_ptr<osg::Texture2D> createTable(CreateImage create, double height)
{
    osg::ref_ptr<SharedBetweenViewers<osg::Texture2D>> texture =
        new SharedBetweenViewers<osg::Texture2D>(getImage(create, height));
    texture->setInternalFormat(GL_RGBA8);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->reserveContexts();
    return texture;
}

osg::ref_ptr<osg::Texture2D> getTable(CreateImage create, const BrickGrid& grid)
{
    static SharedObjects<std::pair<CreateImage, double>, osg::Texture2D> tables;
    const double height = std::clamp(grid.cellSize[grid.getUpIndex()] / grid.getPitch(), LEAST_HEIGHT, MOST_HEIGHT);
    const double shared = std::round(height / HEIGHT_STEP) * HEIGHT_STEP;
    return tables.findOrCreate({create, shared}, [=] { return createTable(create, shared); });
}

GlBuffer uploadBuffer(const osg::State& state, std::span<const BrickNeighbors> neighbors)
{
    GlBuffer buffer(state);
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindBuffer(GL_TEXTURE_BUFFER, buffer.get());
    extensions.glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(neighbors.size_bytes()), neighbors.data(),
                            GL_STATIC_DRAW);
    extensions.glBindBuffer(GL_TEXTURE_BUFFER, 0);
    return buffer;
}

} // namespace

GridOcclusionTextures::GridOcclusionTextures(const osg::State& state, const BrickGrid& grid, GlBuffer&& neighbors,
                                             GLsizei count) :
    _buffer(std::move(neighbors)),
    _neighbors(state), _count(count), _table(osgLego::getTable(createOcclusionTable, grid)),
    _studs(osgLego::getTable(createStudOcclusion, grid))
{
    glBindTexture(GL_TEXTURE_BUFFER, _neighbors.get());
    state.get<osg::GLExtensions>()->glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, _buffer.get());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
}

GridOcclusionTextures::GridOcclusionTextures(const osg::State& state, const BrickGrid& grid,
                                             std::span<const BrickNeighbors> neighbors) :
    GridOcclusionTextures(state, grid, uploadBuffer(state, neighbors), static_cast<GLsizei>(neighbors.size()))
{
}

} // namespace osgLego
