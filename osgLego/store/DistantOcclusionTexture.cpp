#include <osgLego/store/DistantOcclusionTexture.h>

#include <algorithm>

namespace osgLego
{

namespace
{

osg::ref_ptr<osg::Texture3D> createTexture(const osg::Image& image)
{
    // The texture takes no const image; it only reads it.
    osg::ref_ptr<osg::Texture3D> texture = new osg::Texture3D(const_cast<osg::Image*>(&image));
    texture->setInternalFormat(GL_RGBA8);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER,
                       image.isMipmap() ? osg::Texture::LINEAR_MIPMAP_NEAREST : osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    for (const auto wrap : {osg::Texture::WRAP_S, osg::Texture::WRAP_T, osg::Texture::WRAP_R})
        texture->setWrap(wrap, osg::Texture::CLAMP_TO_EDGE);
    return texture;
}

osg::ref_ptr<osg::Image> createUniformImage(int byte)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    std::fill_n(image->data(), 4, static_cast<unsigned char>(byte));
    return image;
}

} // namespace

DistantOcclusionTexture::DistantOcclusionTexture(const DistantOcclusion& occlusion, const BrickGrid& grid) :
    _textures{createTexture(occlusion.getMean()), createTexture(occlusion.getBend())},
    _includesNear(occlusion.includesNear()), _cellsToModel(grid.getCellsToModel())
{
    const osg::Image& image = occlusion.getMean();
    _voxel = 1.0f / glm::vec3(image.s(), image.t(), image.r());
    _scale = _voxel / glm::vec3(occlusion.getCellsPerVoxel());
    _offset = static_cast<float>(DistantOcclusion::BORDER) * _voxel;
}

DistantOcclusionTexture::DistantOcclusionTexture() :
    _textures{createTexture(*createUniformImage(0)), createTexture(*createUniformImage(128))}
{
}

void DistantOcclusionTexture::resizeGLObjectBuffers(unsigned int maxSize) const
{
    for (const osg::ref_ptr<osg::Texture3D>& texture : _textures)
        texture->resizeGLObjectBuffers(maxSize);
}

void DistantOcclusionTexture::releaseGLObjects(osg::State* state) const
{
    for (const osg::ref_ptr<osg::Texture3D>& texture : _textures)
        texture->releaseGLObjects(state);
}

} // namespace osgLego
