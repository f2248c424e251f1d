#include <osgLego/TriangleColor.h>

#include <osgLego/NearestPoint.h>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

glm::dvec3 joined(const glm::dvec3& color, const glm::dvec4& texel, TextureEnvironment environment)
{
    const glm::dvec3 texture(texel);
    switch (environment)
    {
    case TextureEnvironment::REPLACE:
        return texture;
    case TextureEnvironment::DECAL:
        return glm::mix(color, texture, texel.a);
    case TextureEnvironment::ADD:
        return glm::min(color + texture, 1.0);
    case TextureEnvironment::MODULATE:
        break;
    }
    return color * texture;
}

bool haveSameColor(const GridVertex& a, const GridVertex& b)
{
    // The upper half of the second word is the level of the texture.
    constexpr std::uint32_t BLUE = 0xffff;
    return a.colorAndLevel[0] == b.colorAndLevel[0] && ((a.colorAndLevel[1] ^ b.colorAndLevel[1]) & BLUE) == 0;
}

} // namespace

TriangleColor::TriangleColor(const GridBatch& batch, const GridVertex* corners) :
    _batch(batch), _vertices(corners),
    _isEven(!batch.texture && haveSameColor(corners[0], corners[1]) && haveSameColor(corners[0], corners[2]))
{
    _colors[0] = corners[0].getColor();
    if (_isEven) return;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
        _colors[corner] = corners[corner].getColor();
        _corners[corner] = corners[corner].position;
    }
}

glm::vec3 TriangleColor::findColor(const glm::dvec3& middle) const
{
    const glm::dvec3 weights = findNearestPoint(_corners, middle);
    const glm::vec3 shares(weights);
    const glm::vec3 color = shares.x * _colors[0] + shares.y * _colors[1] + shares.z * _colors[2];
    if (!_batch.texture) return color;
    const glm::dvec2 coordinate = weights.x * glm::dvec2(_vertices[0].coordinate) +
                                  weights.y * glm::dvec2(_vertices[1].coordinate) +
                                  weights.z * glm::dvec2(_vertices[2].coordinate);
    return joined(color, _batch.texture->sample(coordinate, _vertices[0].getLevel()), _batch.environment);
}

} // namespace osgLego
