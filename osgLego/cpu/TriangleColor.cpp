#include <osgLego/cpu/TriangleColor.h>

#include <osgLego/flattening/SurfaceColor.h>

#include <algorithm>

namespace osgLego
{

namespace
{

bool haveSameColor(const GridVertex& a, const GridVertex& b)
{
    // The upper half of the second word is the texture level.
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
    _colors[1] = corners[1].getColor();
    _colors[2] = corners[2].getColor();
    _nearestPoint = NearestPoint({corners[0].position, corners[1].position, corners[2].position});
}

void TriangleColor::getColors(std::span<const CellPart> parts, glm::vec3* colors) const
{
    if (_isEven)
    {
        std::fill_n(colors, parts.size(), _colors[0]);
        return;
    }
    for (std::size_t first = 0; first < parts.size(); first += NearestPoint::NUM_LANES)
    {
        // Spare lanes repeat the last part.
        const auto middleOf = [&](int axis)
        {
            return NearestPoint::Lanes([&](std::size_t lane)
                                       { return parts[std::min(first + lane, parts.size() - 1)].cell[axis] + 0.5; });
        };
        const NearestPoint::Shares shares = _nearestPoint.find(middleOf(0), middleOf(1), middleOf(2));
        const std::size_t count = std::min(NearestPoint::NUM_LANES, parts.size() - first);
        for (std::size_t lane = 0; lane < count; ++lane)
            colors[first + lane] = getColor(shares.b[lane], shares.c[lane]);
    }
}

glm::vec3 TriangleColor::getColor(double shareB, double shareC) const
{
    const double shareA = 1.0 - shareB - shareC;
    const glm::vec3 color = static_cast<float>(shareA) * _colors[0] + static_cast<float>(shareB) * _colors[1] +
                            static_cast<float>(shareC) * _colors[2];
    return applyTexture(_batch, _vertices, {shareA, shareB, shareC}, color);
}

} // namespace osgLego
