#include "AssimpMaterials.h"

#include <cmath>

#include <assimp/GltfMaterial.h>
#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/Material>

namespace
{

float clampChannel(float value)
{
    return std::isfinite(value) ? osg::clampBetween(value, 0.0f, 1.0f) : 0.0f;
}

/** The transfer function of sRGB (IEC 61966-2-1). */
float encode(float linear)
{
    return static_cast<float>(linear <= 0.0031308f ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

osg::Texture::WrapMode toWrapMode(aiTextureMapMode mode)
{
    switch (mode)
    {
    case aiTextureMapMode_Clamp:
        return osg::Texture::CLAMP_TO_EDGE;
    case aiTextureMapMode_Mirror:
        return osg::Texture::MIRROR;
    default:
        return osg::Texture::REPEAT;
    }
}

/** Add the base colour texture to a state set. @return the set of its texture coordinates. */
unsigned int addTexture(const aiMaterial& material, AssimpTextures& textures, osg::StateSet& state)
{
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE})
    {
        aiString reference;
        unsigned int channel = 0;
        aiTextureMapMode modes[3]{aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
        if (material.GetTexture(type, 0, &reference, nullptr, &channel, nullptr, nullptr, modes) != aiReturn_SUCCESS ||
            reference.length == 0)
            continue;
        if (const osg::ref_ptr<osg::Image> image = textures.read(reference.C_Str()))
        {
            osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
            texture->setWrap(osg::Texture::WRAP_S, toWrapMode(modes[0]));
            texture->setWrap(osg::Texture::WRAP_T, toWrapMode(modes[1]));
            state.setTextureAttributeAndModes(0, texture);
        }
        return channel;
    }
    return 0;
}

void addAlpha(const aiMaterial& material, float opacity, osg::StateSet& state)
{
    aiString mode;
    // Formats other than glTF have only an opacity.
    if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != aiReturn_SUCCESS) mode = opacity < 1.0f ? "BLEND" : "OPAQUE";
    if (mode == aiString("MASK"))
    {
        float cutoff = 0.5f;
        material.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cutoff);
        state.setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GEQUAL, cutoff));
    }
    else if (mode == aiString("BLEND"))
    {
        state.setAttributeAndModes(new osg::BlendFunc);
        state.setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    }
}

} // namespace

AssimpMaterials::AssimpMaterials(const aiScene& scene, AssimpTextures& textures, bool isLinear) : _isLinear(isLinear)
{
    _white.state = new osg::StateSet;
    _materials.reserve(scene.mNumMaterials);
    for (unsigned int index = 0; index < scene.mNumMaterials; ++index)
        _materials.push_back(create(*scene.mMaterials[index], textures));
}

const AssimpMaterials::Material& AssimpMaterials::get(unsigned int index) const
{
    return index < _materials.size() ? _materials[index] : _white;
}

osg::Vec4 AssimpMaterials::toDisplay(const aiColor4D& color) const
{
    osg::Vec4 display(clampChannel(color.r), clampChannel(color.g), clampChannel(color.b), clampChannel(color.a));
    for (int channel = 0; _isLinear && channel < 3; ++channel)
        display[channel] = encode(display[channel]);
    return display;
}

AssimpMaterials::Material AssimpMaterials::create(const aiMaterial& material, AssimpTextures& textures) const
{
    Material result;
    result.state = new osg::StateSet;
    result.state->setName(material.GetName().C_Str());
    aiColor4D color(1.0f, 1.0f, 1.0f, 1.0f);
    if (material.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS) material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
    aiString gltfMode;
    if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, gltfMode) != aiReturn_SUCCESS) material.Get(AI_MATKEY_OPACITY, color.a);
    result.color = toDisplay(color);
    osg::ref_ptr<osg::Material> surface = new osg::Material;
    surface->setName(material.GetName().C_Str());
    surface->setAmbient(osg::Material::FRONT_AND_BACK, result.color);
    surface->setDiffuse(osg::Material::FRONT_AND_BACK, result.color);
    surface->setColorMode(osg::Material::AMBIENT_AND_DIFFUSE); // geometries have the base colour times their own
    result.state->setAttributeAndModes(surface);
    result.textureChannel = addTexture(material, textures, *result.state);
    addAlpha(material, result.color.a(), *result.state);
    return result;
}
