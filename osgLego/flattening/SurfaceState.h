#pragma once

#include <osgLego/flattening/SurfaceTexture.h>

#include <vector>

#include <osg/Material>
#include <osg/StateSet>
#include <osg/TexMat>
#include <osg/Texture2D>

namespace osgLego
{

/** The state that determines the colour of a drawable: its material, its texture, and how they are combined.
 *
 * The texture is taken from the first unit that has one, because file readers need not use unit 0, and OSG's Collada
 * reader does not. OVERRIDE and PROTECTED work as in osg::State. Textures with generated coordinates (TexGen) are
 * ignored. Holds plain pointers into the state sets that it was created from, and must not outlive them.
 */
class SurfaceState
{
public:
    /** @param stateSets from the outermost node to the drawable; none is null. */
    explicit SurfaceState(const std::vector<const osg::StateSet*>& stateSets);

    const osg::Material* getMaterial() const { return _material; }
    const osg::Texture2D* getTexture() const { return _texture; }
    /** The unit of the texture, whose texture coordinates apply; 0 if there is no texture. */
    unsigned int getTextureUnit() const { return _textureUnit; }
    /** The texture matrix; null if it is the identity. */
    const osg::TexMat* getTextureMatrix() const { return _textureMatrix; }
    TextureEnvironment getEnvironment() const { return _environment; }

    /** Whether the drawable's colour array, if it has one, determines its colour, rather than getColor(). */
    bool usesColorArray() const;
    /** The colour of a drawable that has no colour array or does not use it; 0 to 1 per channel, 0 instead of NaN. */
    osg::Vec4d getColor() const;

private:
    const osg::Material* _material = nullptr;
    const osg::Texture2D* _texture = nullptr;
    unsigned int _textureUnit = 0;
    const osg::TexMat* _textureMatrix = nullptr;
    TextureEnvironment _environment = TextureEnvironment::MODULATE;
    bool _lit = true;
};

} // namespace osgLego
