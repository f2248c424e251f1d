#include <osgLego/polygonization/BrickRanges.h>

#include <osgLego/BrickModel.h>
#include <osgLego/polygonization/StudVisibility.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

/** The maximum of a linear function in a box. */
float mostOf(const glm::vec4& function, const glm::vec3& lower, const glm::vec3& upper)
{
    const glm::vec3 slopes(function);
    const glm::vec3 most = glm::max(slopes * lower, slopes * upper);
    return most.x + most.y + most.z + function.w;
}

/** Tests whether any part of a block, including its studs, may be visible in a view. */
class BlockTest
{
public:
    BlockTest(const CellView& view, Faces faces, int up, float studHeight) :
        _view(view), _faces(faces), _up(up), _studHeight(studHeight)
    {
    }

    bool isInPicture(const BrickBlock& block) const
    {
        glm::vec3 upper(block.maximum + 1);
        upper[_up] += _studHeight;
        return std::all_of(_view.planes.begin(), _view.planes.end(),
                           [&](const glm::vec4& plane)
                           { return mostOf(plane, glm::vec3(block.minimum), upper) >= 0.0f; });
    }

    /** Whether a side or a stud is drawn. */
    bool isDrawn(const BrickBlock& block) const
    {
        if (_faces == Faces::ALL || hasDrawnStuds(block)) return true;
        return _faces == Faces::FRONT ? isTurnedToEye(block) : isTurnedAway(block);
    }

    bool hasDrawnStuds(const BrickBlock& block) const
    {
        return (block.openSides & (SIDE_RIGHT << (2 * _up))) && (_faces != Faces::FRONT || areStudsSeen(block));
    }

    float distanceOf(const BrickBlock& block) const
    {
        const glm::vec3 middle = 0.5f * glm::vec3(block.minimum + block.maximum + 1);
        const glm::vec3 eye(_view.eye);
        return _view.eye.w == 0.0f ? -glm::dot(middle, eye) : glm::distance(middle, eye);
    }

private:
    bool isTurnedToEye(const BrickBlock& block) const
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            const bool isLower = block.openSides & (SIDE_LEFT << (2 * axis));
            const bool isUpper = block.openSides & (SIDE_RIGHT << (2 * axis));
            const auto last = static_cast<float>(block.maximum[axis]);
            const auto first = static_cast<float>(block.minimum[axis] + 1);
            if (isLower && _view.eye[axis] < last * _view.eye.w) return true;
            if (isUpper && _view.eye[axis] > first * _view.eye.w) return true;
        }
        return false;
    }

    bool isTurnedAway(const BrickBlock& block) const
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            const bool isLower = block.openSides & (SIDE_LEFT << (2 * axis));
            const bool isUpper = block.openSides & (SIDE_RIGHT << (2 * axis));
            const auto first = static_cast<float>(block.minimum[axis]);
            const auto last = static_cast<float>(block.maximum[axis] + 1);
            if (isLower && _view.eye[axis] > first * _view.eye.w) return true;
            if (isUpper && _view.eye[axis] < last * _view.eye.w) return true;
        }
        return false;
    }

    /** Whether a stud at any position in the block can be visible. */
    bool areStudsSeen(const BrickBlock& block) const
    {
        const glm::vec3 eye(_view.eye);
        const glm::vec3 first = eye - (glm::vec3(block.minimum) + 0.5f) * _view.eye.w;
        const glm::vec3 last = eye - (glm::vec3(block.maximum) + 0.5f) * _view.eye.w;
        glm::vec3 across = glm::max(glm::abs(first), glm::abs(last));
        across[_up] = 0.0f;
        const float below = static_cast<float>(block.minimum[_up] + 1) * _view.eye.w - eye[_up];
        return BrickDimensions::isStudSeen(glm::length(across), below, _studHeight, _view.eye.w);
    }

    const CellView& _view;
    Faces _faces;
    int _up;
    float _studHeight;
};

} // namespace

void BrickRanges::Parts::clear()
{
    firsts.clear();
    counts.clear();
}

void BrickRanges::Parts::add(const BrickBlock& block)
{
    if (!firsts.empty() && firsts.back() + counts.back() == block.first)
    {
        counts.back() += block.count;
        return;
    }
    firsts.push_back(block.first);
    counts.push_back(block.count);
}

void BrickRanges::find(const std::vector<BrickBlock>& blocks, const BrickGrid& grid, const CellView& view, Faces faces,
                       std::uint32_t numPlaced)
{
    const BlockTest test(view, faces, grid.getUpIndex(), static_cast<float>(grid.getStudHeight()));
    _seen.clear();
    _studded.clear();
    _others.clear();
    for (const BrickBlock& block : blocks)
    {
        if (numPlaced <= block.firstRank || numPlaced > block.lastRank) continue;
        if (!test.isInPicture(block) || !test.isDrawn(block)) continue;
        _seen.push_back({test.distanceOf(block), &block});
        (test.hasDrawnStuds(block) ? _studded : _others).add(block);
    }
    fillAll();
}

void BrickRanges::addTo(PictureTiles& tiles, const BrickGrid& grid, const CellView& view) const
{
    for (const Seen& seen : _seen)
    {
        glm::dvec3 upper(seen.block->maximum + 1);
        upper[grid.getUpIndex()] += grid.getStudHeight();
        tiles.add(view.areaOf(seen.block->minimum, upper));
    }
}

void BrickRanges::sortFrontToBack()
{
    std::sort(_seen.begin(), _seen.end(), [](const Seen& a, const Seen& b) { return a.distance < b.distance; });
    fillAll();
}

void BrickRanges::fillAll()
{
    _all.clear();
    for (const Seen& seen : _seen)
        _all.add(*seen.block);
}

} // namespace osgLego
