#include "Harness.h"

#include <osgLego/LightProbe.h>
#include <osgLego/data/ByteReader.h>
#include <osgLego/light/RadiancePicture.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

// Pictures of light probes, of any size, format and pixels, as plugins of images may give them.

namespace
{

using osgLego::ByteReader;
using osgLego::RadiancePicture;
using osgLego::fuzz::require;

const osg::Vec3d DIRECTIONS[]{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},      {0, -1, 0},
                              {0, 0, 1}, {0, 0, -1}, {0.6, -0.8, 0}, {0, 0.6, 0.8}};

osg::ref_ptr<osg::Image> readImage(ByteReader& reader)
{
    constexpr GLenum FORMATS[]{GL_RGB, GL_RGBA, GL_LUMINANCE, GL_BGRA, GL_BGR, GL_RED, GL_LUMINANCE_ALPHA, GL_ALPHA};
    constexpr GLenum TYPES[]{GL_FLOAT, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_BYTE, GL_HALF_FLOAT, GL_DOUBLE};
    constexpr int PACKINGS[]{1, 2, 4, 8};
    osg::ref_ptr<osg::Image> image = new osg::Image;
    const int width = reader.readNumber<std::uint8_t>() % 17;
    const int height = reader.readNumber<std::uint8_t>() % 17;
    const int depth = 1 + reader.readNumber<std::uint8_t>() / 255;
    const GLenum format = FORMATS[reader.readNumber<std::uint8_t>() % std::size(FORMATS)];
    const GLenum type = TYPES[reader.readNumber<std::uint8_t>() % std::size(TYPES)];
    image->allocateImage(width, height, depth, format, type, PACKINGS[reader.readNumber<std::uint8_t>() % 4]);
    std::generate_n(image->data(), image->data() ? image->getTotalSizeInBytes() : 0,
                    [&reader] { return reader.readNumber<std::uint8_t>(); });
    return image;
}

void checkLight(const osg::Vec3d& light)
{
    for (int channel = 0; channel < 3; ++channel)
        require(std::isfinite(light[channel]) && light[channel] >= 0.0, "light is finite and not negative");
}

void checkPicture(const osg::Image& image, osgLego::LightProbe::Mapping mapping)
{
    std::string error;
    const std::optional<RadiancePicture> picture = RadiancePicture::read(image, mapping, error);
    require(picture.has_value() == error.empty(), "there is a picture, or there is a reason: " + error);
    if (!picture) return;
    for (const osg::Vec3d& direction : DIRECTIONS)
        checkLight(picture->getRadiance(direction));
}

/** The whole probe. */
void checkProbe(const osg::Image& image, osgLego::LightProbe::Mapping mapping)
{
    const osg::ref_ptr<osgLego::LightProbe> probe = new osgLego::LightProbe;
    std::string error;
    if (!probe->setImage(&image, mapping, error)) return;
    for (const osg::Vec3d& direction : DIRECTIONS)
        checkLight(probe->getIrradiance(direction));
    require(std::isfinite(probe->getHarmonicError()), "the error of the harmonics is finite");
    require(probe->getReflectionMap(2), "there are reflection maps");
}

/** Whether the whole probe is checked, too. It takes thousands of times as long as the picture: few inputs are chosen,
 * by a hash, so that libFuzzer does not learn to prefer them. */
bool isChosen(std::string_view input)
{
    return std::hash<std::string_view>()(input) % 16384 == 0;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view input = osgLego::fuzz::toText(data, size);
    ByteReader reader(input);
    const auto mapping = static_cast<osgLego::LightProbe::Mapping>(reader.readNumber<std::uint8_t>() % 3);
    const osg::ref_ptr<osg::Image> image = readImage(reader);
    checkPicture(*image, mapping);
    if (isChosen(input)) checkProbe(*image, mapping);
    return 0;
}
