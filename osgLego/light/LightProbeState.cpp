#include <osgLego/light/LightProbeState.h>

#include <osgLego/data/SharedObjects.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/SharedBetweenViewers.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/light/SphericalHarmonics.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <osg/Math>
#include <osg/Matrixd>
#include <osg/Texture2D>
#include <osg/Uniform>
#include <osg/observer_ptr>

namespace osgLego
{

namespace
{

/** Create the texture of a latitude-longitude picture: it repeats horizontally and is clamped at top and bottom. */
osg::ref_ptr<osg::Texture2D> createMapTexture(osg::Image& image, bool hasLevels)
{
    // Both formats must be equal: otherwise OSG allocates a reused texture a second time, which GL rejects.
    image.setInternalTextureFormat(GL_RGB16F_ARB);
    // Prevents OSG from dropping the image once it is loaded, since other contexts may need it later.
    image.setDataVariance(osg::Object::DYNAMIC);
    osg::ref_ptr<SharedBetweenViewers<osg::Texture2D>> texture = new SharedBetweenViewers<osg::Texture2D>(&image);
    texture->setInternalFormat(GL_RGB16F_ARB);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setFilter(osg::Texture::MIN_FILTER, hasLevels ? osg::Texture::LINEAR_MIPMAP_LINEAR : osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->reserveContexts();
    return texture;
}

/** Create the convolved map for shaders/light/ambient_light.glsl, with the poles in the centres of the first and last
 * row. */
osg::ref_ptr<osg::Image> createConvolvedMap(const LightProbe& probe)
{
    const int width = LightProbe::CONVOLVED_WIDTH;
    const int height = LightProbe::CONVOLVED_WIDTH / 2 + 1;
    osg::ref_ptr<LightProbe> plain = new LightProbe(probe);
    plain->setRotation(osg::Quat());
    plain->setIntensity(1.0);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGB, GL_FLOAT);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
        {
            const double longitude = ((column + 0.5) / width - 0.5) * 2.0 * osg::PI;
            const double latitude = (static_cast<double>(row) / (height - 1) - 0.5) * osg::PI;
            const osg::Vec3d direction(std::sin(longitude) * std::cos(latitude),
                                       std::cos(longitude) * std::cos(latitude), std::sin(latitude));
            const osg::Vec3d light = plain->getIrradiance(direction);
            auto* pixel = reinterpret_cast<float*>(
                image->data(static_cast<unsigned int>(column), static_cast<unsigned int>(row)));
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] = static_cast<float>(light[channel]);
        }
    return image;
}

/** Create an image with the reflection maps of all roughnesses as mipmap levels. GL requires further levels below the
 * last one; they repeat its first pixel. */
osg::ref_ptr<osg::Image> createLevels(const LightProbe& probe)
{
    std::vector<float> all;
    osg::Image::MipmapDataType offsets;
    const osg::Image& first = *probe.getReflectionMap(0);
    for (int level = 0, width = first.s(), height = first.t();; ++level)
    {
        if (level > 0) offsets.push_back(static_cast<unsigned int>(all.size() * sizeof(float)));
        const osg::Image& map = *probe.getReflectionMap(std::min(level, LightProbe::REFLECTION_LEVELS - 1));
        const auto* pixels = reinterpret_cast<const float*>(map.data());
        const std::size_t count = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        for (std::size_t value = 0; value < count; ++value)
            all.push_back(level < LightProbe::REFLECTION_LEVELS ? pixels[value] : pixels[value % 3]);
        if (width == 1 && height == 1) break;
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    }

    auto* data = new unsigned char[all.size() * sizeof(float)];
    std::copy_n(reinterpret_cast<const unsigned char*>(all.data()), all.size() * sizeof(float), data);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(first.s(), first.t(), 1, GL_RGB16F_ARB, GL_RGB, GL_FLOAT, data, osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

enum class Map
{
    CONVOLVED,
    REFLECTION
};

/** The texture of a map, which depends only on the light of the probe, and which probes with the same light share. */
osg::ref_ptr<osg::Texture2D> getMapTexture(const LightProbe& probe, Map map)
{
    // Each light has its own convolved map.
    static SharedObjects<std::pair<osg::observer_ptr<const osg::Image>, Map>, osg::Texture2D> textures;
    const auto create = [&]
    {
        const bool isConvolved = map == Map::CONVOLVED;
        return createMapTexture(isConvolved ? *createConvolvedMap(probe) : *createLevels(probe), !isConvolved);
    };
    return textures.findOrCreate({probe.getConvolvedMap(), map}, create);
}

void setMap(osg::StateSet& stateSet, unsigned int unit, const char* name, const LightProbe& probe, Map map)
{
    stateSet.setTextureAttribute(unit, getMapTexture(probe, map), OVERRIDE_PROTECTED);
    stateSet.addUniform(new osg::Uniform(name, static_cast<int>(unit)));
}

} // namespace

void applyLightProbe(const LightProbe& probe, osg::StateSet& stateSet)
{
    const auto coefficients = SphericalHarmonics::toIrradiancePolynomial(probe.getCoefficients());
    osg::ref_ptr<osg::Uniform> polynomial =
        new osg::Uniform(osg::Uniform::FLOAT_VEC3, "irradiancePolynomial", SphericalHarmonics::COUNT);
    for (unsigned int index = 0; index < coefficients.size(); ++index)
        polynomial->setElement(index, osg::Vec3(coefficients[index]));
    stateSet.addUniform(polynomial);
    stateSet.addUniform(new osg::Uniform("probeIntensity", static_cast<float>(probe.getIntensity())));
    stateSet.addUniform(new osg::Uniform("worldToProbe", toUniform(osg::Matrixd(probe.getRotation().inverse()))));
    if (probe.usesConvolvedMap()) setMap(stateSet, CONVOLVED_MAP_UNIT, "convolvedMap", probe, Map::CONVOLVED);
    setMap(stateSet, REFLECTION_MAP_UNIT, "reflectionMap", probe, Map::REFLECTION);
}

std::string defineLightProbe(const LightProbe& probe)
{
    return probe.usesConvolvedMap() ? "#define CONVOLVED_MAP\n" : "";
}

} // namespace osgLego
