#pragma once

#include <osgLego/flattening/SurfaceTexture.h>

#include <map>

#include <osg/Image>
#include <osg/Texture2D>
#include <osg/observer_ptr>
#include <osg/ref_ptr>

namespace osgLego
{

/** Keeps the SurfaceTextures of a source from one flattening to the next, so that a moving source does not make them
 * again, and a source whose texture has released its image (Texture::setUnRefImageDataAfterApply) keeps its colours.
 *
 * One thread at a time. */
class SurfaceTextureCache
{
public:
    /** The SurfaceTexture of a texture; null if its image can't be read. */
    osg::ref_ptr<const SurfaceTexture> findOrMake(const osg::Texture2D& texture);
    /** Drop the entries that findOrMake() has not returned since the last call. */
    void dropUnused();

private:
    struct Entry
    {
        osg::observer_ptr<const osg::Image> image; // a reference would keep the image from being released
        unsigned int modifiedCount = 0;
        osg::Texture::WrapMode wrapS = osg::Texture::CLAMP;
        osg::Texture::WrapMode wrapT = osg::Texture::CLAMP;
        osg::Vec4d borderColor;
        osg::ref_ptr<const SurfaceTexture> surface;
        bool isUsed = false;

        bool isOf(const osg::Texture2D& texture) const;
    };

    std::map<osg::ref_ptr<const osg::Texture2D>, Entry> _entries;
};

} // namespace osgLego
