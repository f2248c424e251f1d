#include <osgLego/cpu/TriangleColor.h>

#include <osgLego/cpu/DominantColors.h>
#include <osgLego/flattening/SurfaceColor.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

// Nearer colours are hardly better: they differ by less than the preference for dark colours.
constexpr float CLOSE =
    static_cast<float>(PassConstants::RED_BIAS + PassConstants::GREEN_BIAS + PassConstants::BLUE_BIAS);

bool haveSameColor(const GridVertex& a, const GridVertex& b)
{
    // The upper half of the second word is the texture level.
    constexpr std::uint32_t BLUE = 0xffff;
    return a.colorAndLevel[0] == b.colorAndLevel[0] && ((a.colorAndLevel[1] ^ b.colorAndLevel[1]) & BLUE) == 0;
}

/** How much a colour is a mixture of two others: twice its distance from the nearer one if it lies between both, so
 * that the nearer one stands better for an area of any mixture. */
float measureMixture(const glm::vec3& color, const glm::vec3& a, const glm::vec3& b)
{
    const float toA = glm::distance(color, a);
    const float toB = glm::distance(color, b);
    const float detour = toA + toB - glm::distance(a, b);
    return 2.0f * std::max(0.0f, std::min(toA, toB) - detour);
}

} // namespace

/** The texels of a triangle in a cell, for shaders/voxelization/dominant_color.frag's rule. */
class TriangleColor::PlainTexels
{
public:
    /** In quarters of a cell from its centre. */
    static constexpr std::array<glm::dvec2, 5> OFFSETS{glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 1.0),
                                                       glm::dvec2(1.0, -1.0), glm::dvec2(-1.0, 1.0),
                                                       glm::dvec2(-1.0, -1.0)};

    /** @param corners of the triangle, whose level is the one at which a cell is two texels wide. */
    PlainTexels(const SurfaceTexture& texture, const GridVertex* corners)
    {
        const glm::ivec2 size = texture.getSize();
        const double level = corners[0].getLevel();
        _quarter = 0.5 * std::exp2(level) / glm::dvec2(size);
        // Texels of a sixteenth of a cell: small enough for pure colours, and large enough to be typical of the cell.
        const int last = static_cast<int>(std::bit_width(static_cast<unsigned int>(std::max(size.x, size.y)))) - 1;
        _level = std::clamp(static_cast<int>(level) - 3, 0, last);
        _size = glm::max(size >> _level, 1);
        const glm::dvec2 a = corners[0].coordinate;
        const glm::dvec2 b = corners[1].coordinate;
        const glm::dvec2 c = corners[2].coordinate;
        // Rounded coordinates of a border between texels may be beyond it.
        constexpr double ROUNDING = 0.01;
        const glm::dvec2 lowest = glm::min(glm::min(a, b), c) * _size;
        const glm::dvec2 highest = glm::max(glm::max(a, b), c) * _size;
        _last = glm::max(glm::ceil(highest - ROUNDING) - 1.0, glm::floor(lowest));
        _first = glm::min(glm::floor(lowest + ROUNDING), _last);
        _mixtureCost = static_cast<float>(std::clamp(level, 0.0, 1.0));
    }

    int getLevel() const { return _level; }
    /** 1, or less where a cell is less than four texels wide: there, texels may be what the picture shows, such as the
     * shades of pixel art. */
    float getMixtureCost() const { return _mixtureCost; }

    /** The number of a texel, or of the nearest one in the triangle's rectangle: others may belong to other surfaces.
     */
    glm::dvec2 findTexel(const glm::dvec2& center, const glm::dvec2& offset) const
    {
        return glm::clamp(glm::floor((center + offset * _quarter) * _size), _first, _last);
    }

    /** The centre of a texel. */
    glm::dvec2 getCoordinate(const glm::dvec2& texel) const { return (texel + 0.5) / _size; }

private:
    glm::dvec2 _quarter{0.0};
    int _level = 0;
    glm::dvec2 _size{1.0};
    glm::dvec2 _first{0.0};
    glm::dvec2 _last{0.0};
    float _mixtureCost = 0.0f;
};

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
        std::fill_n(colors, parts.size(), _colors[0]);
    else
        forEachPoint(parts, [&](std::size_t part, const glm::dvec3& shares)
                     { colors[part] = applyTexture(_batch, _vertices, shares, getVertexColor(shares)); });
}

void TriangleColor::makePlain(std::span<const CellPart> parts, glm::vec3* colors) const
{
    const PlainTexels texels(*_batch.texture, _vertices);
    forEachPoint(parts, [&](std::size_t part, const glm::dvec3& shares)
                 { colors[part] = getPlainColor(texels, shares, colors[part]); });
}

/** Call a function with the number of each part and the barycentric coordinates of the point nearest to its centre. */
template <typename GetColor>
void TriangleColor::forEachPoint(std::span<const CellPart> parts, const GetColor& getColor) const
{
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
        {
            const double b = shares.b[lane];
            const double c = shares.c[lane];
            getColor(first + lane, glm::dvec3(1.0 - b - c, b, c));
        }
    }
}

glm::vec3 TriangleColor::getVertexColor(const glm::dvec3& shares) const
{
    return static_cast<float>(shares.x) * _colors[0] + static_cast<float>(shares.y) * _colors[1] +
           static_cast<float>(shares.z) * _colors[2];
}

glm::vec3 TriangleColor::getPlainColor(const PlainTexels& texels, const glm::dvec3& shares,
                                       const glm::vec3& filtered) const
{
    const glm::vec3 vertexColor = getVertexColor(shares);
    const glm::dvec2 center = coordinateAt(_vertices, shares);
    const auto getColor = [&](const glm::dvec2& texel)
    { return applyTexel(_batch, texels.getCoordinate(texel), texels.getLevel(), vertexColor); };
    glm::vec3 nearest(0.0f);
    float best = std::numeric_limits<float>::max();
    glm::dvec2 previous(std::numeric_limits<double>::quiet_NaN()); // differs from every texel
    for (const glm::dvec2& offset : PlainTexels::OFFSETS)
    {
        const glm::dvec2 texel = texels.findTexel(center, offset);
        if (texel == previous) continue;
        previous = texel;
        const glm::vec3 color = getColor(texel);
        const float score = dominanceScore(color, filtered);
        if (score >= best) continue;
        // A texel on a border between colours may be a mixture of those of its neighbours.
        const auto measure = [&](const glm::dvec2& side)
        { return measureMixture(color, getColor(texel - side), getColor(texel + side)); };
        float mixture = texels.getMixtureCost();
        if (mixture > 0.0f) mixture *= std::max(measure(glm::dvec2(1.0, 0.0)), measure(glm::dvec2(0.0, 1.0)));
        if (score + mixture < best)
        {
            nearest = color;
            best = score + mixture;
        }
        // Most cells are inside areas of nearly one colour.
        if (glm::distance(color, filtered) + mixture < CLOSE) break;
    }
    return nearest;
}

} // namespace osgLego
