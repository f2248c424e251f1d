#include <osgLego/SurfaceState.h>

#include <algorithm>

#include <osg/TexEnv>

namespace osgLego
{

namespace
{

/** A value inherited from state set to state set, as osg::State inherits modes and attributes. */
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

} // namespace

SurfaceState::SurfaceState(const std::vector<const osg::StateSet*>& stateSets)
{
    InheritedAttribute material;
    InheritedAttribute texture;
    InheritedAttribute textureMatrix;
    InheritedAttribute environment;
    InheritedMode lighting;
    InheritedMode texturing;
    InheritedMode generated;
    for (const osg::StateSet* stateSet : stateSets)
    {
        material.push(stateSet->getAttributePair(osg::StateAttribute::MATERIAL));
        lighting.push(stateSet->getMode(GL_LIGHTING));
        texture.push(stateSet->getTextureAttributePair(0, osg::StateAttribute::TEXTURE));
        textureMatrix.push(stateSet->getTextureAttributePair(0, osg::StateAttribute::TEXMAT));
        environment.push(stateSet->getTextureAttributePair(0, osg::StateAttribute::TEXENV));
        texturing.push(stateSet->getTextureMode(0, GL_TEXTURE_2D));
        generated.push(stateSet->getTextureMode(0, GL_TEXTURE_GEN_S));
    }

    _material = material.get<osg::Material>();
    _lit = lighting.get(true);
    if (texturing.get(false) && !generated.get(false)) _texture = texture.get<osg::Texture2D>();
    _environment = environmentOf(environment.get<osg::TexEnv>());
    _textureMatrix = textureMatrix.get<osg::TexMat>();
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
    // What glows by itself is seen in its own light, even where no lamp reaches it.
    if (_lit) color += _material->getEmission(osg::Material::FRONT);
    for (unsigned int channel = 0; channel < 4; ++channel)
        color[channel] = std::clamp(color[channel], 0.0, 1.0);
    return color;
}

} // namespace osgLego
