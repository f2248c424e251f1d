#include <osgLego/layout/IndexLayer.h>

#include <algorithm>

namespace osgLego
{

IndexLayer::IndexLayer(const glm::ivec3& size) :
    _stride(static_cast<std::size_t>(size.x) + 2), _indices(_stride * (static_cast<std::size_t>(size.y) + 2), NONE)
{
}

void IndexLayer::clear()
{
    std::fill(_indices.begin(), _indices.end(), NONE);
}

void IndexLayer::fill(const glm::ivec2& place, const glm::ivec2& size, std::uint32_t index)
{
    for (int y = place.y; y < place.y + size.y; ++y)
    {
        const auto row = _indices.begin() + static_cast<std::ptrdiff_t>(getOffset(place.x, y));
        std::fill(row, row + size.x, index);
    }
}

} // namespace osgLego
