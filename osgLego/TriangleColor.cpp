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

} // namespace

TriangleColor::TriangleColor(const GridBatch& batch, const GridVertex* corners) :
    _batch(batch), _vertices(corners), _corners{corners[0].position, corners[1].position, corners[2].position},
    _colors{corners[0].getColor(), corners[1].getColor(), corners[2].getColor()},
    _isEven(!batch.texture && _colors[0] == _colors[1] && _colors[0] == _colors[2])
{
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
