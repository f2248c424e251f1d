#include <osgLego/light/RadiancePicture.h>

#include <osgLego/light/LatitudeLongitude.h>
#include <osgLego/text/CountedNoun.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>

#include <osg/Notify>

namespace osgLego
{

namespace
{

using std::numbers::pi;
constexpr int PIECES_ACROSS = 512;
constexpr int RIM_PIECES = 8;
constexpr float LARGEST_HALF = 65504.0f;

/** The positions of red, green and blue in a pixel of an osg::Image. */
struct ChannelOrder
{
    std::size_t count = 0; // 0: a format that can't be read
    std::array<std::size_t, 3> channels{0, 0, 0};
};

ChannelOrder channelOrderOf(GLenum pixelFormat)
{
    switch (pixelFormat)
    {
    case GL_LUMINANCE:
    case GL_RED:
        return {1, {0, 0, 0}};
    case GL_RGB:
        return {3, {0, 1, 2}};
    case GL_RGBA:
        return {4, {0, 1, 2}};
    case GL_BGR:
        return {3, {2, 1, 0}};
    case GL_BGRA:
        return {4, {2, 1, 0}};
    default:
        return {};
    }
}

std::size_t bytesOf(GLenum type)
{
    switch (type)
    {
    case GL_UNSIGNED_BYTE:
        return 1;
    case GL_UNSIGNED_SHORT:
        return 2;
    case GL_FLOAT:
        return 4;
    default:
        return 0;
    }
}

float linearOf(double display)
{
    return static_cast<float>(display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4));
}

/** Compute the linear value of each of `levels` display values: a table is faster than a power for every pixel. */
std::vector<float> makeLinearTable(std::size_t levels)
{
    std::vector<float> table(levels);
    for (std::size_t level = 0; level < levels; ++level)
        table[level] = linearOf(static_cast<double>(level) / static_cast<double>(levels - 1));
    return table;
}

/** Reads channels of any supported type. */
class ChannelReader
{
public:
    explicit ChannelReader(GLenum type) : _bytes(bytesOf(type))
    {
        if (_bytes < 4) _table = makeLinearTable(std::size_t(1) << (8 * _bytes));
    }

    float read(const unsigned char* pixel, std::size_t channel) const
    {
        const unsigned char* data = pixel + channel * _bytes;
        if (_bytes == 1) return _table[*data];
        if (_bytes == 2) return _table[valueOf<std::uint16_t>(data)];
        return valueOf<float>(data);
    }

private:
    template <typename Value>
    static Value valueOf(const unsigned char* data)
    {
        Value value;
        std::memcpy(&value, data, sizeof(value));
        return value;
    }

    std::size_t _bytes;
    std::vector<float> _table;
};

std::string sizeOf(const osg::Image& image)
{
    return std::to_string(image.s()) + " x " + std::to_string(image.t());
}

std::string findFault(const osg::Image& image, ProbeFormat::Mapping mapping)
{
    if (!image.data() || image.s() < 1 || image.t() < 1) return "the picture of a light probe has no pixels";
    if (image.r() != 1)
        return "the picture of a light probe has " + std::to_string(image.r()) + " layers; expected one";
    if (channelOrderOf(image.getPixelFormat()).count == 0)
        return "the picture of a light probe has " +
               std::to_string(osg::Image::computeNumComponents(image.getPixelFormat())) +
               " channels, or channels other than colours; expected grey, RGB or RGBA, uncompressed";
    if (bytesOf(image.getDataType()) == 0)
        return "the picture of a light probe has channels of another type; expected floats, unsigned bytes or "
               "unsigned shorts";
    if (mapping == ProbeFormat::AUTO && image.s() != image.t() && image.s() / 2.0 != image.t())
        return "the picture of a light probe is " + sizeOf(image) +
               " pixels; expected twice as wide as high (latitude and longitude), or square (an angular map)";
    if (mapping == ProbeFormat::ANGULAR && image.s() != image.t())
        return "the angular map of a light probe is " + sizeOf(image) + " pixels; expected a square";
    return {};
}

int piecesOf(int pixels, int least)
{
    return (least + pixels - 1) / pixels;
}

} // namespace

RadiancePicture::RadiancePicture(int width, int height, bool angular) :
    _width(width), _height(height), _angular(angular),
    _pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
{
}

std::optional<RadiancePicture> RadiancePicture::read(const osg::Image& image, ProbeFormat::Mapping mapping,
                                                     std::string& error)
{
    error = findFault(image, mapping);
    if (!error.empty()) return std::nullopt;

    const bool angular = mapping == ProbeFormat::ANGULAR || (mapping == ProbeFormat::AUTO && image.s() == image.t());
    RadiancePicture picture(image.s(), image.t(), angular);
    const ChannelOrder order = channelOrderOf(image.getPixelFormat());
    const std::size_t pixelBytes = order.count * bytesOf(image.getDataType());
    const ChannelReader reader(image.getDataType());
    auto pixel = picture._pixels.begin();
    for (int row = 0; row < image.t(); ++row)
    {
        const unsigned char* data = image.data(0, static_cast<unsigned int>(row));
        for (int column = 0; column < image.s(); ++column, data += pixelBytes, ++pixel)
            for (int channel = 0; channel < 3; ++channel)
                (*pixel)[channel] = reader.read(data, order.channels[static_cast<std::size_t>(channel)]);
    }
    if (picture.mend()) return picture;
    error = "the picture of a light probe gives no light; expected at least one finite pixel above 0";
    return std::nullopt;
}

RadiancePicture RadiancePicture::create(int width, int height,
                                        const std::function<osg::Vec3d(const osg::Vec3d& direction)>& radianceOf)
{
    RadiancePicture picture(width, height, false);
    auto pixel = picture._pixels.begin();
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            *pixel++ = radianceOf(LatitudeLongitude::directionAt((column + 0.5) / width, (row + 0.5) / height));
    return picture;
}

bool RadiancePicture::mend()
{
    std::size_t dark = 0;
    std::size_t endless = 0;
    bool light = false;
    for (osg::Vec3f& color : _pixels)
    {
        bool isDark = false;
        bool isEndless = false;
        for (int channel = 0; channel < 3; ++channel)
        {
            float& value = color[channel];
            // Comparisons with NaN are false.
            isDark = isDark || !(value >= 0.0f);
            isEndless = isEndless || value > std::numeric_limits<float>::max();
            light = light || (value > 0.0f && value <= std::numeric_limits<float>::max());
            value = value > 0.0f ? value : 0.0f;
            if (value > std::numeric_limits<float>::max()) value = LARGEST_HALF;
        }
        dark += isDark;
        endless += isEndless;
    }
    if (light && dark > 0)
        OSG_WARN << "osgLego: " << counted(dark, "pixel", "pixels")
                 << " of a light probe's picture with negative values or without numbers; they count as 0" << std::endl;
    if (light && endless > 0)
        OSG_WARN << "osgLego: " << counted(endless, "infinite pixel", "infinite pixels")
                 << " of a light probe's picture; they count as " << LARGEST_HALF << std::endl;
    return light;
}

const osg::Vec3f& RadiancePicture::pixel(int column, int row) const
{
    return _pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(_width) + static_cast<std::size_t>(column)];
}

osg::Vec3d RadiancePicture::getRadiance(const osg::Vec3d& direction) const
{
    osg::Vec2d place;
    if (_angular)
    {
        const double sine = std::hypot(direction.x(), direction.z());
        const double scale = sine > 0.0 ? 0.5 * std::acos(std::clamp(direction.y(), -1.0, 1.0)) / (pi * sine) : 0.0;
        place.set(0.5 + scale * direction.x(), 0.5 + scale * direction.z());
    }
    else
        place = LatitudeLongitude::coordinatesOf(direction);
    return pixel(std::clamp(static_cast<int>(place.x() * _width), 0, _width - 1),
                 std::clamp(static_cast<int>(place.y() * _height), 0, _height - 1));
}

void RadiancePicture::visit(const std::function<void(const Piece&)>& function) const
{
    if (_angular)
        visitCircle(function);
    else
        visitLatitudesAndLongitudes(function);
}

void RadiancePicture::visitLatitudesAndLongitudes(const std::function<void(const Piece&)>& function) const
{
    const int columnPieces = piecesOf(_width, PIECES_ACROSS);
    const int rowPieces = piecesOf(_height, PIECES_ACROSS / 2);
    const int columns = columnPieces * _width;
    const int rows = rowPieces * _height;
    std::vector<osg::Vec3d> equator;
    equator.reserve(static_cast<std::size_t>(columns));
    for (int column = 0; column < columns; ++column)
        equator.push_back(LatitudeLongitude::directionAt((column + 0.5) / columns, 0.5));

    Piece piece;
    for (int row = 0; row < rows; ++row)
    {
        const double latitude = pi * ((row + 0.5) / rows - 0.5);
        const double cosine = std::cos(latitude);
        const double sine = std::sin(latitude);
        piece.solidAngle = LatitudeLongitude::solidAngleOf(row, columns, rows);
        for (int column = 0; column < columns; ++column)
        {
            const osg::Vec3d& flat = equator[static_cast<std::size_t>(column)];
            piece.direction.set(cosine * flat.x(), cosine * flat.y(), sine);
            piece.place.set((column + 0.5) / columns, (row + 0.5) / rows);
            piece.radiance = pixel(column / columnPieces, row / rowPieces);
            function(piece);
        }
    }
}

void RadiancePicture::visitCircle(const std::function<void(const Piece&)>& function) const
{
    const double pixelSize = 2.0 / _width; // if the radius of the circle is 1
    const int innerPieces = piecesOf(_width, PIECES_ACROSS);
    Piece piece;
    for (int row = 0; row < _height; ++row)
        for (int column = 0; column < _width; ++column)
        {
            const double distance = std::hypot((column + 0.5) * pixelSize - 1.0, (row + 0.5) * pixelSize - 1.0);
            if (distance > 1.0 + pixelSize) continue;
            const int pieces = distance < 1.0 - pixelSize ? innerPieces : std::max(innerPieces, RIM_PIECES);
            const double size = pixelSize / pieces;
            piece.radiance = pixel(column, row);
            for (int part = 0; part < pieces * pieces; ++part)
            {
                const int partRow = part / pieces;
                const double x = column * pixelSize - 1.0 + (part % pieces + 0.5) * size;
                const double z = row * pixelSize - 1.0 + (partRow + 0.5) * size;
                const double radius = std::hypot(x, z);
                if (radius >= 1.0) continue;
                // A ring of the circle, 2 pi r dr, maps to a ring of the sphere, 2 pi sin(pi r) d(pi r).
                const double angle = pi * radius;
                const double stretch = radius > 1e-9 ? std::sin(angle) / radius : pi;
                piece.direction.set(x * stretch, std::cos(angle), z * stretch);
                piece.place = LatitudeLongitude::coordinatesOf(piece.direction);
                piece.solidAngle = pi * stretch * size * size;
                function(piece);
            }
        }
}

} // namespace osgLego
