#include "ImageConversion.h"

#include <common/PictureFile.h>

#include <algorithm>
#include <memory>
#include <new>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <osg/GL>
#include <osg/Texture>

namespace
{

constexpr int MAXIMUM_CHANNELS = 4;
// OSG's images hold colours that are not multiplied by alpha.
constexpr const char* STRAIGHT_ALPHA = "oiio:UnassociatedAlpha";
// Larger than any texture, yet small enough that a corrupt header does no harm.
constexpr double MAXIMUM_BYTES = 4.0 * (1u << 30);

/** The representation of a channel in an osg::Image. */
struct ChannelType
{
    OIIO::TypeDesc oiio;
    GLenum gl;
    GLenum internalFormats[MAXIMUM_CHANNELS];
};

const ChannelType BYTES{
    OIIO::TypeDesc::UINT8, GL_UNSIGNED_BYTE, {GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8, GL_RGB8, GL_RGBA8}};
const ChannelType SHORTS{
    OIIO::TypeDesc::UINT16, GL_UNSIGNED_SHORT, {GL_LUMINANCE16, GL_LUMINANCE16_ALPHA16, GL_RGB16, GL_RGBA16}};
const ChannelType FLOATS{
    OIIO::TypeDesc::FLOAT, GL_FLOAT, {GL_LUMINANCE32F_ARB, GL_LUMINANCE_ALPHA32F_ARB, GL_RGB32F_ARB, GL_RGBA32F_ARB}};
constexpr GLenum PIXEL_FORMATS[MAXIMUM_CHANNELS]{GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_RGBA};

const ChannelType& typeFor(const OIIO::TypeDesc& format)
{
    switch (format.basetype)
    {
    case OIIO::TypeDesc::UINT8:
        return BYTES;
    case OIIO::TypeDesc::UINT16:
        return SHORTS;
    default:
        return FLOATS;
    }
}

std::string findFault(const OIIO::ImageSpec& spec, int channels, const ChannelType& type)
{
    const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
    if (spec.depth > 1) return "it has " + std::to_string(spec.depth) + " layers; expected one";
    if (spec.deep) return "it is a deep image; expected a flat one";
    if (spec.width < 1 || spec.height < 1 || channels < 1)
        return "it has no pixels (" + size + "); expected at least 1 x 1";
    const double bytes =
        static_cast<double>(spec.width) * spec.height * channels * static_cast<double>(type.oiio.size());
    if (bytes > MAXIMUM_BYTES) return "its header announces " + size + " pixels; expected up to 4 GiB of them";
    return {};
}

osg::ref_ptr<osg::Image> readPixels(OIIO::ImageInput& input, std::string& error)
{
    const OIIO::ImageSpec& spec = input.spec();
    const int channels = std::min(spec.nchannels, MAXIMUM_CHANNELS);
    const ChannelType& type = typeFor(spec.format);
    error = findFault(spec, channels, type);
    if (!error.empty()) return nullptr;

    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(spec.width, spec.height, 1, PIXEL_FORMATS[channels - 1], type.gl);
    if (!image->data()) throw std::bad_alloc();
    image->setInternalTextureFormat(static_cast<GLint>(type.internalFormats[channels - 1]));
    const auto rowBytes = static_cast<OIIO::stride_t>(image->getRowStepInBytes());
    unsigned char* top = image->data(0, static_cast<unsigned int>(spec.height - 1));
    if (input.read_image(0, 0, 0, channels, type.oiio, top, OIIO::AutoStride, -rowBytes)) return image;
    error = input.geterror();
    return nullptr;
}

/** The channels of an OSG pixel format, in the order of image files; empty for formats without colours. */
std::vector<int> channelOrder(GLenum pixelFormat)
{
    switch (pixelFormat)
    {
    case GL_LUMINANCE:
    case GL_ALPHA:
    case GL_RED:
    case GL_INTENSITY:
    case GL_DEPTH_COMPONENT:
        return {0};
    case GL_LUMINANCE_ALPHA:
    case GL_RG:
        return {0, 1};
    case GL_RGB:
        return {0, 1, 2};
    case GL_RGBA:
        return {0, 1, 2, 3};
    case GL_BGR:
        return {2, 1, 0};
    case GL_BGRA:
        return {2, 1, 0, 3};
    default:
        return {};
    }
}

/** The image's rows from top to bottom, its channels in the order of image files. */
std::vector<unsigned char> collectPixels(const osg::Image& image, const std::vector<int>& order,
                                         std::size_t channelBytes)
{
    std::vector<unsigned char> pixels;
    pixels.reserve(order.size() * channelBytes * static_cast<std::size_t>(image.s()) *
                   static_cast<std::size_t>(image.t()));
    for (int row = image.t(); row-- > 0;)
        for (int column = 0; column < image.s(); ++column)
        {
            const unsigned char* pixel = image.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            for (const int channel : order)
            {
                const unsigned char* value = pixel + static_cast<std::size_t>(channel) * channelBytes;
                pixels.insert(pixels.end(), value, value + channelBytes);
            }
        }
    return pixels;
}

} // namespace

osg::ref_ptr<osg::Image> readWithOiio(const std::string& fileName, std::string& error)
{
    try
    {
        OIIO::ImageSpec request;
        request.attribute(STRAIGHT_ALPHA, 1);
        const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(fileName, &request);
        if (!input)
        {
            error = OIIO::geterror();
            return nullptr;
        }
        osg::ref_ptr<osg::Image> image = readPixels(*input, error);
        if (image) image->setFileName(fileName);
        return image;
    }
    catch (const std::bad_alloc&)
    {
        error = "there is not enough memory for its pixels";
        return nullptr;
    }
}

std::string writeWithOiio(const osg::Image& image, const std::string& fileName)
{
    if (image.r() != 1) return "it has " + std::to_string(image.r()) + " layers; expected one";
    const std::vector<int> order = channelOrder(image.getPixelFormat());
    const ChannelType* type = nullptr;
    for (const ChannelType* candidate : {&BYTES, &SHORTS, &FLOATS})
        if (candidate->gl == image.getDataType()) type = candidate;
    if (!image.data() || order.empty() || !type)
        return "its pixel format is not supported; expected one to four channels of unsigned bytes, unsigned shorts or "
               "floats";

    OIIO::ImageSpec spec(image.s(), image.t(), static_cast<int>(order.size()), type->oiio);
    spec.attribute(STRAIGHT_ALPHA, 1);
    std::vector<unsigned char> pixels = collectPixels(image, order, type->oiio.size());
    return osgLego::writePictureFile(fileName, OIIO::ImageBuf(spec, pixels.data()));
}
