#include <osgLego/flattening/SurfaceTexture.h>

#include <osgLego/data/MipmapFootprint.h>
#include <osgLego/flattening/ColorFraction.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <osg/Notify>

namespace osgLego
{

namespace
{

/** An image in floating point, from which the next mipmap level is computed without rounding twice. */
struct FloatImage
{
    glm::ivec2 size{0};
    std::vector<glm::vec4> texels;

    glm::vec4& at(int column, int row)
    {
        return texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
                      static_cast<std::size_t>(column)];
    }
};

FloatImage makeFloatImage(const glm::ivec2& size)
{
    return {size, std::vector<glm::vec4>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y))};
}

FloatImage readImage(const osg::Image& image)
{
    FloatImage result = makeFloatImage({image.s(), image.t()});
    for (int row = 0; row < image.t(); ++row)
    {
        for (int column = 0; column < image.s(); ++column)
        {
            const osg::Vec4 color = image.getColor(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            const glm::vec4 texel(color.r(), color.g(), color.b(), color.a());
            for (int channel = 0; channel < 4; ++channel)
                result.at(column, row)[channel] = toColorFraction(texel[channel]);
        }
    }
    return result;
}

FloatImage halved(FloatImage& image)
{
    FloatImage result = makeFloatImage(glm::max(image.size / 2, glm::ivec2(1)));
    for (int row = 0; row < result.size.y; ++row)
    {
        const MipmapFootprint rows(row, result.size.y, image.size.y);
        for (int column = 0; column < result.size.x; ++column)
        {
            const MipmapFootprint columns(column, result.size.x, image.size.x);
            glm::vec4 sum(0.0f);
            for (std::size_t v = 0; v < rows.weights.size(); ++v)
                for (std::size_t u = 0; u < columns.weights.size(); ++u)
                    sum += rows.weights[v] * columns.weights[u] *
                           image.at(columns.first + static_cast<int>(u), rows.first + static_cast<int>(v));
            result.at(column, row) = sum;
        }
    }
    return result;
}

void appendBytes(const FloatImage& image, std::vector<unsigned char>& bytes)
{
    for (const glm::vec4& texel : image.texels)
        for (int channel = 0; channel < 4; ++channel)
            bytes.push_back(static_cast<unsigned char>(std::lround(255.0f * texel[channel])));
}

osg::Texture::WrapMode simplified(osg::Texture::WrapMode mode)
{
    // Some drivers still blend half of the border into the edge for GL_CLAMP, which users never want.
    return mode == osg::Texture::CLAMP ? osg::Texture::CLAMP_TO_EDGE : mode;
}

/** The texel at an index that may be outside the image; -1 for the border. */
int wrapped(int index, int size, osg::Texture::WrapMode mode)
{
    const auto modulo = [](int value, int period) { return ((value % period) + period) % period; };
    switch (mode)
    {
    case osg::Texture::REPEAT:
        return modulo(index, size);
    case osg::Texture::MIRROR:
    {
        const int folded = modulo(index, 2 * size);
        return folded < size ? folded : 2 * size - 1 - folded;
    }
    case osg::Texture::CLAMP_TO_BORDER:
        return index < 0 || index >= size ? -1 : index;
    default:
        return std::clamp(index, 0, size - 1);
    }
}

/** A texture coordinate in texels, reduced to the range of an int: far outside the image, only the position within a
 * period matters. */
double inTexels(double coordinate, int size, osg::Texture::WrapMode mode)
{
    if (!std::isfinite(coordinate)) return 0.0;
    if (mode == osg::Texture::REPEAT)
        coordinate -= std::floor(coordinate);
    else if (mode == osg::Texture::MIRROR)
        coordinate -= 2.0 * std::floor(0.5 * coordinate);
    else
        coordinate = std::clamp(coordinate, -1.0, 2.0);
    return coordinate * size;
}

bool canBeRead(const osg::Image& image)
{
    return image.data() != nullptr && image.s() > 0 && image.t() > 0 && !image.isCompressed();
}

} // namespace

osg::ref_ptr<SurfaceTexture> SurfaceTexture::create(const osg::Texture2D& texture)
{
    const osg::Image* source = texture.getImage();
    if (!source || !canBeRead(*source))
    {
        OSG_WARN << "osgLego: the texture image '" << (source ? source->getFileName() : texture.getName())
                 << "' is compressed, empty or missing, and is ignored; expected an uncompressed image" << std::endl;
        return nullptr;
    }

    FloatImage image = readImage(*source);
    while (std::max(image.size.x, image.size.y) > MAXIMUM_SIZE)
        image = halved(image);
    const glm::ivec2 baseSize = image.size;

    std::vector<unsigned char> bytes;
    std::vector<glm::ivec2> sizes;
    osg::Image::MipmapDataType offsets;
    while (true)
    {
        if (!sizes.empty()) offsets.push_back(static_cast<unsigned int>(bytes.size()));
        sizes.push_back(image.size);
        appendBytes(image, bytes);
        if (image.size == glm::ivec2(1)) break;
        image = halved(image);
    }

    osg::ref_ptr<SurfaceTexture> result = new SurfaceTexture;
    result->_wrapS = simplified(texture.getWrap(osg::Texture::WRAP_S));
    result->_wrapT = simplified(texture.getWrap(osg::Texture::WRAP_T));
    for (unsigned int channel = 0; channel < 4; ++channel)
        result->_borderColor[channel] = toColorFraction(texture.getBorderColor()[channel]);
    auto* data = new unsigned char[bytes.size()]; // osg::Image frees it with delete[]
    std::copy(bytes.begin(), bytes.end(), data);
    result->_image = new osg::Image;
    result->_image->setImage(baseSize.x, baseSize.y, 1, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, data,
                             osg::Image::USE_NEW_DELETE);
    result->_image->setMipmapLevels(offsets);
    for (std::size_t level = 0; level < sizes.size(); ++level)
        result->_levels.push_back({sizes[level], data + (level == 0 ? 0 : offsets[level - 1])});
    return result;
}

glm::dvec4 SurfaceTexture::sample(const glm::dvec2& coordinate, double level) const
{
    const double last = static_cast<double>(_levels.size() - 1);
    const double clamped = level > 0.0 ? std::min(level, last) : 0.0;
    const auto fine = static_cast<std::size_t>(clamped);
    const double fraction = clamped - static_cast<double>(fine);
    const glm::dvec4 color = sampleLevel(_levels[fine], coordinate);
    if (fraction == 0.0) return color;
    return glm::mix(color, sampleLevel(_levels[fine + 1], coordinate), fraction);
}

glm::dvec4 SurfaceTexture::getTexel(const glm::dvec2& coordinate, int level) const
{
    const Level& own = _levels[static_cast<std::size_t>(std::clamp(level, 0, static_cast<int>(_levels.size()) - 1))];
    return fetch(own, static_cast<int>(std::floor(inTexels(coordinate.x, own.size.x, _wrapS))),
                 static_cast<int>(std::floor(inTexels(coordinate.y, own.size.y, _wrapT))));
}

glm::dvec4 SurfaceTexture::sampleLevel(const Level& level, const glm::dvec2& coordinate) const
{
    const glm::dvec2 position(inTexels(coordinate.x, level.size.x, _wrapS) - 0.5,
                              inTexels(coordinate.y, level.size.y, _wrapT) - 0.5);
    const glm::dvec2 corner = glm::floor(position);
    const glm::dvec2 fraction = position - corner;
    const int column = static_cast<int>(corner.x);
    const int row = static_cast<int>(corner.y);
    return glm::mix(glm::mix(fetch(level, column, row), fetch(level, column + 1, row), fraction.x),
                    glm::mix(fetch(level, column, row + 1), fetch(level, column + 1, row + 1), fraction.x), fraction.y);
}

glm::dvec4 SurfaceTexture::fetch(const Level& level, int column, int row) const
{
    const int s = wrapped(column, level.size.x, _wrapS);
    const int t = wrapped(row, level.size.y, _wrapT);
    if (s < 0 || t < 0) return {_borderColor.x(), _borderColor.y(), _borderColor.z(), _borderColor.w()};
    const unsigned char* texel = level.texels + 4 * (static_cast<std::ptrdiff_t>(t) * level.size.x + s);
    return glm::dvec4(texel[0], texel[1], texel[2], texel[3]) / 255.0;
}

} // namespace osgLego
