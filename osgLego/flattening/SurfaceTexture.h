#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <osg/Image>
#include <osg/Referenced>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** How a texture is combined with the colour below it, as with glTexEnv. */
enum class TextureEnvironment
{
    MODULATE, //!< colour x texture
    REPLACE,  //!< texture
    DECAL,    //!< colour and texture mixed by the texture's alpha
    ADD       //!< colour + texture
};

/** The texture of a surface, filtered to any size, with the same result on the CPU and in GL.
 *
 * Holds the image of an osg::Texture2D as 8-bit RGBA together with its mipmaps (box filter), its wrap modes and its
 * border colour, and samples it at a given level like GL_LINEAR_MIPMAP_LINEAR. Since it is a copy, the osg::Texture2D
 * may release its image, or change, afterwards. Texels and border colours are limited to 0 to 1; channels that are NaN
 * become 0. Texture coordinates that are not finite count as 0.
 *
 * Preconditions:
 * 1. The image is uncompressed. A compressed image can't be read without GL; create() returns null for it.
 * 2. The sides have at most MAXIMUM_SIZE texels. Larger images are halved until they fit: bricks are never that small.
 *
 * Usage:
 *
 *     osg::ref_ptr<osgLego::SurfaceTexture> surface = osgLego::SurfaceTexture::create(*texture2D);
 *     if (surface) colour = surface->sample({0.5, 0.5}, 0.0);
 *
 * Uses no GL. Immutable once created; every function may be called from any thread.
 */
class SurfaceTexture : public osg::Referenced
{
public:
    static constexpr int MAXIMUM_SIZE = 4096;

    /** Copy the image of a texture. @return null, with a warning, if it is missing or can't be read. */
    static osg::ref_ptr<SurfaceTexture> create(const osg::Texture2D& texture);

    /** The colour at a texture coordinate (1 is the size of the image), 0 to 1 per channel.
     * @param level 0 for the image itself, 1 for half its size, and so on; fractions blend two levels. Clamped to the
     * levels that exist. */
    glm::dvec4 sample(const glm::dvec2& coordinate, double level) const;

    /** The colour of the texel that contains a texture coordinate, 0 to 1 per channel.
     * @param level from 0; clamped to the levels that exist. */
    glm::dvec4 getTexel(const glm::dvec2& coordinate, int level) const;

    /** The size of level 0, in texels. */
    glm::ivec2 getSize() const { return _levels.front().size; }

    /** Level 0 and its mipmaps in one GL_RGBA, GL_UNSIGNED_BYTE image, for use in GL. */
    osg::Image* getImage() const { return _image.get(); }
    osg::Texture::WrapMode getWrapS() const { return _wrapS; }
    osg::Texture::WrapMode getWrapT() const { return _wrapT; }
    const osg::Vec4d& getBorderColor() const { return _borderColor; }

private:
    struct Level
    {
        glm::ivec2 size{0};
        const unsigned char* texels = nullptr;
    };

    SurfaceTexture() = default;
    ~SurfaceTexture() override = default;

    glm::dvec4 fetch(const Level& level, int column, int row) const;
    glm::dvec4 sampleLevel(const Level& level, const glm::dvec2& coordinate) const;

    osg::ref_ptr<osg::Image> _image;
    std::vector<Level> _levels;
    osg::Texture::WrapMode _wrapS = osg::Texture::CLAMP_TO_EDGE;
    osg::Texture::WrapMode _wrapT = osg::Texture::CLAMP_TO_EDGE;
    osg::Vec4d _borderColor;
};

} // namespace osgLego
