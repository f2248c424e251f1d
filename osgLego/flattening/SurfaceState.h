#pragma once

#include <osgLego/flattening/SurfaceTexture.h>

#include <vector>

#include <osg/Material>
#include <osg/StateSet>
#include <osg/TexMat>
#include <osg/Texture2D>

namespace osgLego
{

/** What the state sets above a drawable make of its colour: the material, the texture, and how they join.
 *
 * The texture is that of the first unit with one: readers need not put it into unit 0, and OSG's of Collada does not.
 * OVERRIDE and PROTECTED count as in osg::State. Textures whose coordinates depend on the eye (TexGen) are left out.
 * Holds bare pointers into the state sets it was made of, and is not to outlive them.
 */
class SurfaceState
{
public:
    /** @param stateSets from the outermost node to the drawable; no null among them. */
    explicit SurfaceState(const std::vector<const osg::StateSet*>& stateSets);

    const osg::Material* getMaterial() const { return _material; }
    const osg::Texture2D* getTexture() const { return _texture; }
    /** The unit of the texture, whose coordinates are meant; 0 when there is none. */
    unsigned int getTextureUnit() const { return _textureUnit; }
    /** The texture matrix, null when it is the identity. */
    const osg::TexMat* getTextureMatrix() const { return _textureMatrix; }
    TextureEnvironment getEnvironment() const { return _environment; }

    /** Whether the drawable's colour array, if it has one, is shown; otherwise getColor() is. */
    bool usesColorArray() const;
    /** The colour of a drawable without colour array, or whose array is not used; 0 to 1 a channel. */
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
