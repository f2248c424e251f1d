#include <osgLego/flattening/SurfaceColor.h>

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

glm::vec3 applyTexture(const GridBatch& batch, const glm::dvec2& coordinate, double level, const glm::vec3& color)
{
    return joined(color, batch.texture->sample(coordinate, level), batch.environment);
}

glm::vec3 applyTexel(const GridBatch& batch, const glm::dvec2& coordinate, int level, const glm::vec3& color)
{
    return joined(color, batch.texture->getTexel(coordinate, level), batch.environment);
}

glm::dvec2 coordinateAt(const GridVertex* corners, const glm::dvec3& shares)
{
    return shares.x * glm::dvec2(corners[0].coordinate) + shares.y * glm::dvec2(corners[1].coordinate) +
           shares.z * glm::dvec2(corners[2].coordinate);
}

glm::vec3 applyTexture(const GridBatch& batch, const GridVertex* corners, const glm::dvec3& shares,
                       const glm::vec3& color)
{
    if (!batch.texture) return color;
    return applyTexture(batch, coordinateAt(corners, shares), corners[0].getLevel(), color);
}

} // namespace osgLego
