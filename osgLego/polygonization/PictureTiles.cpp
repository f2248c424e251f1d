#include <osgLego/polygonization/PictureTiles.h>

#include <algorithm>

#include <glm/common.hpp>

namespace osgLego
{

void PictureTiles::clear(const glm::ivec2& size)
{
    _size = size;
    _count = (size + SIDE - 1) / SIDE;
    _isUsed.assign(static_cast<std::size_t>(_count.x * _count.y), 0);
}

void PictureTiles::add(const glm::vec4& area)
{
    if (_isUsed.empty()) return;
    constexpr float MARGIN = 0.5f; // pixels, to allow for rounding
    const glm::vec4 pixels = (0.5f * area + 0.5f) * glm::vec4(_size, _size);
    const glm::ivec2 last = _count - 1;
    const glm::ivec2 begin = glm::clamp(glm::ivec2(glm::floor(glm::vec2(pixels) - MARGIN)) / SIDE, glm::ivec2(0), last);
    const glm::ivec2 end =
        glm::clamp(glm::ivec2(glm::floor(glm::vec2(pixels.z, pixels.w) + MARGIN)) / SIDE, glm::ivec2(0), last);
    for (int row = begin.y; row <= end.y; ++row)
        std::fill_n(_isUsed.begin() + row * _count.x + begin.x, end.x - begin.x + 1, std::uint8_t(1));
}

void PictureTiles::findRuns()
{
    _firsts.clear();
    _counts.clear();
    for (auto begin = _isUsed.begin(); begin != _isUsed.end();)
    {
        begin = std::find(begin, _isUsed.end(), 1);
        const auto end = std::find(begin, _isUsed.end(), 0);
        if (begin == end) break;
        _firsts.push_back(static_cast<int>(begin - _isUsed.begin()));
        _counts.push_back(static_cast<int>(end - begin));
        begin = end;
    }
}

} // namespace osgLego
