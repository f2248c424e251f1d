#include <osgLego/polygonization/FittedTiles.h>

#include <initializer_list>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr int ALIGNMENT = 4;   // pixels: software renderers shade blocks of 4 x 4, whole or in part
constexpr float MARGIN = 0.5f; // pixels, to allow for rounding

glm::vec4 toPixels(const glm::vec4& area, const glm::ivec2& size)
{
    return (0.5f * glm::clamp(area, -1.0f, 1.0f) + 0.5f) * glm::vec4(size, size);
}

} // namespace

bool FittedTiles::isSmall(const glm::vec4& area, const glm::ivec2& size)
{
    const glm::vec4 pixels = toPixels(area, size);
    return (pixels.z - pixels.x) * (pixels.w - pixels.y) <= static_cast<float>(LARGEST_AREA);
}

FittedTiles FittedTiles::fit(const glm::vec4& area, const glm::ivec2& size)
{
    FittedTiles tiles;
    const bool isOutside = area.x > 1.0f || area.y > 1.0f || area.z < -1.0f || area.w < -1.0f;
    if (isOutside || size.x <= 0 || size.y <= 0) return tiles;
    const glm::vec4 pixels = toPixels(area, size);
    const glm::ivec2 lower = glm::max(glm::ivec2(glm::floor(glm::vec2(pixels) - MARGIN)), 0);
    const glm::ivec2 upper = glm::min(glm::ivec2(glm::ceil(glm::vec2(pixels.z, pixels.w) + MARGIN)), size);
    tiles.first = lower / ALIGNMENT * ALIGNMENT;
    const glm::ivec2 extent = upper - tiles.first;
    int least = 0;
    for (const int side : {32, 24, 16, 12, 8})
    {
        const glm::ivec2 count = (extent + side - 1) / side;
        const int numPixels = count.x * count.y * side * side;
        if (least != 0 && numPixels >= least) continue;
        least = numPixels;
        tiles.count = count;
        tiles.side = side;
    }
    return tiles;
}

} // namespace osgLego
