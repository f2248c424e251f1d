#include <osgLego/flattening/SurfaceState.h>

#include <osgLego/flattening/ColorFraction.h>

#include <algorithm>

#include <osg/TexEnv>

namespace osgLego
{

namespace
{

/** A value inherited from state set to state set, by the rules of osg::State for modes and attributes. */
template <typename Value>
class Inherited
{
public:
    void push(Value value, unsigned int flags)
    {
        const bool held = (_flags & osg::StateAttribute::OVERRIDE) && !(flags & osg::StateAttribute::PROTECTED);
        if (_set && held) return;
        _set = true;
        _value = value;
        _flags = flags;
    }

    bool isSet() const { return _set; }
    Value get() const { return _value; }

private:
    bool _set = false;
    Value _value{};
    unsigned int _flags = 0;
};

class InheritedAttribute
{
public:
    void push(const osg::StateSet::RefAttributePair* pair)
    {
        if (pair) _attribute.push(pair->first.get(), pair->second);
    }

    template <typename Attribute>
    const Attribute* get() const
    {
        return dynamic_cast<const Attribute*>(_attribute.get());
    }

private:
    Inherited<const osg::StateAttribute*> _attribute;
};

class InheritedMode
{
public:
    void push(osg::StateAttribute::GLModeValue value)
    {
        if (!(value & osg::StateAttribute::INHERIT)) _on.push(value & osg::StateAttribute::ON, value);
    }

    bool get(bool otherwise) const { return _on.isSet() ? _on.get() : otherwise; }

private:
    Inherited<bool> _on;
};

TextureEnvironment environmentOf(const osg::TexEnv* environment)
{
    if (!environment) return TextureEnvironment::MODULATE;
    switch (environment->getMode())
    {
    case osg::TexEnv::REPLACE:
        return TextureEnvironment::REPLACE;
    case osg::TexEnv::DECAL:
        return TextureEnvironment::DECAL;
    case osg::TexEnv::ADD:
        return TextureEnvironment::ADD;
    default:
        return TextureEnvironment::MODULATE;
    }
}

/** The inherited state of one texture unit. */
class InheritedUnit
{
public:
    void push(const osg::StateSet& stateSet, unsigned int unit)
    {
        _texture.push(stateSet.getTextureAttributePair(unit, osg::StateAttribute::TEXTURE));
        _matrix.push(stateSet.getTextureAttributePair(unit, osg::StateAttribute::TEXMAT));
        _environment.push(stateSet.getTextureAttributePair(unit, osg::StateAttribute::TEXENV));
        _texturing.push(stateSet.getTextureMode(unit, GL_TEXTURE_2D));
        _generated.push(stateSet.getTextureMode(unit, GL_TEXTURE_GEN_S));
    }

    /** Null if no texture is visible. */
    const osg::Texture2D* getTexture() const
    {
        return _texturing.get(false) && !_generated.get(false) ? _texture.get<osg::Texture2D>() : nullptr;
    }
    const osg::TexMat* getMatrix() const { return _matrix.get<osg::TexMat>(); }
    const osg::TexEnv* getEnvironment() const { return _environment.get<osg::TexEnv>(); }

private:
    InheritedAttribute _texture;
    InheritedAttribute _matrix;
    InheritedAttribute _environment;
    InheritedMode _texturing;
    InheritedMode _generated;
};

unsigned int countTextureUnits(const std::vector<const osg::StateSet*>& stateSets)
{
    std::size_t count = 0;
    for (const osg::StateSet* stateSet : stateSets)
        count = std::max({count, stateSet->getTextureAttributeList().size(), stateSet->getTextureModeList().size()});
    return static_cast<unsigned int>(count);
}

} // namespace

SurfaceState::SurfaceState(const std::vector<const osg::StateSet*>& stateSets)
{
    InheritedAttribute material;
    InheritedMode lighting;
    for (const osg::StateSet* stateSet : stateSets)
    {
        material.push(stateSet->getAttributePair(osg::StateAttribute::MATERIAL));
        lighting.push(stateSet->getMode(GL_LIGHTING));
    }

    _material = material.get<osg::Material>();
    _lit = lighting.get(true);
    const unsigned int numUnits = countTextureUnits(stateSets);
    for (unsigned int number = 0; number < numUnits && !_texture; ++number)
    {
        InheritedUnit unit;
        for (const osg::StateSet* stateSet : stateSets)
            unit.push(*stateSet, number);
        if (!unit.getTexture()) continue;
        _textureUnit = number;
        _texture = unit.getTexture();
        _environment = environmentOf(unit.getEnvironment());
        _textureMatrix = unit.getMatrix();
    }
    if (_textureMatrix && _textureMatrix->getMatrix().isIdentity()) _textureMatrix = nullptr;
}

bool SurfaceState::usesColorArray() const
{
    if (!_material || !_lit) return true;
    const osg::Material::ColorMode mode = _material->getColorMode();
    return mode == osg::Material::DIFFUSE || mode == osg::Material::AMBIENT_AND_DIFFUSE;
}

osg::Vec4d SurfaceState::getColor() const
{
    if (!_material) return {1.0, 1.0, 1.0, 1.0};
    osg::Vec4d color = _material->getDiffuse(osg::Material::FRONT);
    // Emission is visible even where no light source reaches.
    if (_lit) color += _material->getEmission(osg::Material::FRONT);
    for (unsigned int channel = 0; channel < 4; ++channel)
        color[channel] = toColorFraction(color[channel]);
    return color;
}

} // namespace osgLego
