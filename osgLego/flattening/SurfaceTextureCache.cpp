#include <osgLego/flattening/SurfaceTextureCache.h>

#include <osgLego/data/SharedObjects.h>

namespace osgLego
{

namespace
{

/** The values that determine a surface texture. */
struct SurfaceKey
{
    osg::observer_ptr<const osg::Image> image;
    unsigned int modifiedCount = 0;
    osg::Texture::WrapMode wrapS = osg::Texture::CLAMP;
    osg::Texture::WrapMode wrapT = osg::Texture::CLAMP;
    osg::Vec4d borderColor;

    bool operator==(const SurfaceKey&) const = default;
};

/** The surface texture of a texture, which sources with the same image share. */
osg::ref_ptr<const SurfaceTexture> getShared(const osg::Texture2D& texture)
{
    static SharedObjects<SurfaceKey, const SurfaceTexture> surfaces;
    const osg::Image* image = texture.getImage();
    if (!image) return SurfaceTexture::create(texture);
    return surfaces.findOrCreate({image, image->getModifiedCount(), texture.getWrap(osg::Texture::WRAP_S),
                                  texture.getWrap(osg::Texture::WRAP_T), texture.getBorderColor()},
                                 [&texture] { return SurfaceTexture::create(texture); });
}

} // namespace

bool SurfaceTextureCache::Entry::isOf(const osg::Texture2D& texture) const
{
    if (texture.getWrap(osg::Texture::WRAP_S) != wrapS || texture.getWrap(osg::Texture::WRAP_T) != wrapT ||
        osg::Vec4d(texture.getBorderColor()) != borderColor)
        return false;
    const osg::Image* current = texture.getImage();
    return !current || (image == current && current->getModifiedCount() == modifiedCount);
}

osg::ref_ptr<const SurfaceTexture> SurfaceTextureCache::findOrMake(const osg::Texture2D& texture)
{
    const auto [place, isNew] = _entries.try_emplace(&texture);
    Entry& entry = place->second;
    entry.isUsed = true;
    if (!isNew && entry.isOf(texture)) return entry.surface;

    const osg::Image* image = texture.getImage();
    // Once the image has been released, a change of the wrap mode can no longer take effect.
    if (isNew || image) entry.surface = getShared(texture);
    entry.image = image;
    entry.modifiedCount = image ? image->getModifiedCount() : 0;
    entry.wrapS = texture.getWrap(osg::Texture::WRAP_S);
    entry.wrapT = texture.getWrap(osg::Texture::WRAP_T);
    entry.borderColor = texture.getBorderColor();
    return entry.surface;
}

void SurfaceTextureCache::dropUnused()
{
    std::erase_if(_entries, [](const auto& entry) { return !entry.second.isUsed; });
    for (auto& [texture, entry] : _entries)
        entry.isUsed = false;
}

} // namespace osgLego
