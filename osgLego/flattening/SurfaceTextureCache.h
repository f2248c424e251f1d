#pragma once

#include <osgLego/flattening/SurfaceTexture.h>

#include <map>

#include <osg/Image>
#include <osg/Texture2D>
#include <osg/observer_ptr>
#include <osg/ref_ptr>

namespace osgLego
{

/** The SurfaceTextures of a source from one flattening to the next, so that a source that moves does not have them made
 * anew, and one whose texture has let go of its image (Texture::setUnRefImageDataAfterApply) keeps its colours.
 *
 * Not for several threads at once. */
class SurfaceTextureCache
{
public:
    /** The surface of a texture; null when its image can't be read. */
    osg::ref_ptr<const SurfaceTexture> findOrMake(const osg::Texture2D& texture);
    /** Let go of what nobody has asked for since the last call. */
    void dropUnused();

private:
    struct Entry
    {
        osg::observer_ptr<const osg::Image> image; // no more, or there would be no use in letting go of it
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
