#include "RandomMesh.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <type_traits>

#include <osg/Geometry>
#include <osg/Image>
#include <osg/MatrixTransform>
#include <osg/Texture2D>

namespace osgLego::fuzz
{

namespace
{

// Enough for every case, and so few that OSG's own code stays quick.
constexpr std::uint8_t MOST_VERTICES = 64;
constexpr std::uint8_t MOST_SETS = 8;

/** The parts of a mesh that are not always there, as bits. */
enum Content : std::uint8_t
{
    ANY_NUMBERS = 1, // those of any bits, such as NaN, rather than small ones
    COLORS = 2,
    COORDINATES = 4,
    TEXTURE = 8,
    TRANSFORM = 16
};

float readFloat(ByteReader& reader, bool isAny)
{
    if (isAny) return std::bit_cast<float>(reader.readNumber<std::uint32_t>());
    return static_cast<float>(reader.readNumber<std::uint8_t>()) / 32.0f - 4.0f;
}

template <typename Component>
Component readComponent(ByteReader& reader, bool isAny)
{
    if constexpr (std::is_same_v<Component, double>)
        return isAny ? reader.readDouble() : static_cast<double>(readFloat(reader, false));
    else if constexpr (std::is_same_v<Component, float>)
        return readFloat(reader, isAny);
    else
        return static_cast<Component>(reader.readNumber<std::make_unsigned_t<Component>>());
}

template <typename Array>
osg::ref_ptr<osg::Array> readElements(ByteReader& reader, std::size_t count, bool isAny)
{
    using Vector = typename Array::ElementDataType;
    osg::ref_ptr<Array> array = new Array;
    for (std::size_t index = 0; index < count; ++index)
    {
        Vector element;
        for (int component = 0; component < Vector::num_components; ++component)
            element[component] = readComponent<typename Vector::value_type>(reader, isAny);
        array->push_back(element);
    }
    return array;
}

osg::ref_ptr<osg::Array> readArray(ByteReader& reader, bool isAny)
{
    using Read = osg::ref_ptr<osg::Array> (*)(ByteReader&, std::size_t, bool);
    constexpr Read READERS[]{
        readElements<osg::Vec3Array>,   readElements<osg::Vec3dArray>, readElements<osg::Vec4Array>,
        readElements<osg::Vec2Array>,   readElements<osg::Vec4dArray>, readElements<osg::Vec3bArray>,
        readElements<osg::Vec4ubArray>, readElements<osg::Vec3sArray>, readElements<osg::Vec3usArray>,
        readElements<osg::Vec3iArray>,  readElements<osg::Vec2uiArray>};
    const std::size_t kind = reader.readNumber<std::uint8_t>() % std::size(READERS);
    const std::size_t count = reader.readNumber<std::uint8_t>() % (MOST_VERTICES + 1);
    return READERS[kind](reader, count, isAny);
}

template <typename Set>
osg::ref_ptr<osg::PrimitiveSet> readElementsOf(ByteReader& reader, GLenum mode)
{
    osg::ref_ptr<Set> set = new Set(mode);
    for (int left = reader.readNumber<std::uint8_t>(); left > 0; --left)
        set->push_back(reader.readNumber<std::uint8_t>());
    // One index beyond all arrays, if the type can hold it.
    if (reader.readNumber<std::uint8_t>() == 0xff) set->push_back(static_cast<typename Set::value_type>(0xfffffffe));
    return set;
}

osg::ref_ptr<osg::PrimitiveSet> readLengths(ByteReader& reader, GLenum mode)
{
    osg::ref_ptr<osg::DrawArrayLengths> set = new osg::DrawArrayLengths(mode);
    set->setFirst(static_cast<std::int8_t>(reader.readNumber<std::uint8_t>()));
    for (int left = reader.readNumber<std::uint8_t>() % 16; left > 0; --left)
        set->push_back(static_cast<std::int16_t>(reader.readNumber<std::uint16_t>()));
    return set;
}

osg::ref_ptr<osg::PrimitiveSet> readPrimitives(ByteReader& reader)
{
    const GLenum mode = reader.readNumber<std::uint8_t>() % 16; // all modes of GL, and one that does not exist
    switch (reader.readNumber<std::uint8_t>() % 5)
    {
    case 0:
    {
        const auto first = static_cast<std::int16_t>(reader.readNumber<std::uint16_t>());
        return new osg::DrawArrays(mode, first, static_cast<std::int16_t>(reader.readNumber<std::uint16_t>()));
    }
    case 1:
        return readElementsOf<osg::DrawElementsUByte>(reader, mode);
    case 2:
        return readElementsOf<osg::DrawElementsUShort>(reader, mode);
    case 3:
        return readElementsOf<osg::DrawElementsUInt>(reader, mode);
    default:
        return readLengths(reader, mode);
    }
}

void readTexture(ByteReader& reader, osg::StateSet& state)
{
    constexpr GLenum FORMATS[]{GL_RGB,   GL_RGBA,           GL_LUMINANCE, GL_BGRA, GL_LUMINANCE_ALPHA,
                               GL_ALPHA, GL_DEPTH_COMPONENT};
    constexpr GLenum TYPES[]{GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT, GL_BYTE, GL_UNSIGNED_SHORT_5_6_5};
    constexpr int PACKINGS[]{1, 2, 4, 8};
    constexpr osg::Texture::WrapMode WRAPS[]{osg::Texture::CLAMP, osg::Texture::REPEAT, osg::Texture::MIRROR,
                                             osg::Texture::CLAMP_TO_BORDER};
    osg::ref_ptr<osg::Image> image = new osg::Image;
    const int width = reader.readNumber<std::uint8_t>() % 5;
    const int height = reader.readNumber<std::uint8_t>() % 5;
    const GLenum format = FORMATS[reader.readNumber<std::uint8_t>() % std::size(FORMATS)];
    const GLenum type = TYPES[reader.readNumber<std::uint8_t>() % std::size(TYPES)];
    image->allocateImage(width, height, 1, format, type, PACKINGS[reader.readNumber<std::uint8_t>() % 4]);
    std::generate_n(image->data(), image->data() ? image->getTotalSizeInBytes() : 0,
                    [&reader] { return reader.readNumber<std::uint8_t>(); });
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, WRAPS[reader.readNumber<std::uint8_t>() % std::size(WRAPS)]);
    texture->setWrap(osg::Texture::WRAP_T, WRAPS[reader.readNumber<std::uint8_t>() % std::size(WRAPS)]);
    state.setTextureAttributeAndModes(0, texture);
}

osg::ref_ptr<osg::Geometry> readGeometry(ByteReader& reader, std::uint8_t content)
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    const bool isAny = (content & ANY_NUMBERS) != 0;
    geometry->setVertexArray(readArray(reader, isAny));
    if (content & COLORS)
    {
        const int binding = reader.readNumber<std::uint8_t>() % 5; // those of osg::Array, from BIND_OFF on
        geometry->setColorArray(readArray(reader, isAny), static_cast<osg::Array::Binding>(binding));
    }
    if (content & COORDINATES) geometry->setTexCoordArray(0, readArray(reader, isAny));
    for (int left = 1 + reader.readNumber<std::uint8_t>() % MOST_SETS; left > 0; --left)
        geometry->addPrimitiveSet(readPrimitives(reader));
    return geometry;
}

} // namespace

osg::ref_ptr<osg::Node> createRandomMesh(ByteReader& reader)
{
    const auto content = reader.readNumber<std::uint8_t>();
    osg::ref_ptr<osg::MatrixTransform> root = new osg::MatrixTransform;
    const osg::ref_ptr<osg::Geometry> geometry = readGeometry(reader, content);
    if (content & TEXTURE) readTexture(reader, *geometry->getOrCreateStateSet());
    root->addChild(geometry);
    if (content & TRANSFORM)
    {
        osg::Matrixd matrix;
        for (int index = 0; index < 16; ++index)
            matrix.ptr()[index] = readFloat(reader, (content & ANY_NUMBERS) != 0);
        root->setMatrix(matrix);
    }
    return root;
}

} // namespace osgLego::fuzz
