#include <osgLego/building/StepViews.h>

#include <osgLego/data/GrazingView.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

constexpr double DEGREE = std::numbers::pi / 180.0;

/** The direction to the eye, in cells. */
glm::dvec3 getDirection(const BuildingView& view, int turns, double cellHeight)
{
    const double azimuth = view.azimuth * DEGREE + 0.5 * std::numbers::pi * turns;
    const double elevation = view.elevation * DEGREE;
    return {std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation) / cellHeight};
}

} // namespace

StepViews::StepViews(const std::vector<BuildingBox>& boxes, double cellHeight, const BuildingView& view,
                     bool mayPlanTurns) :
    _boxes(boxes),
    _cellHeight(cellHeight), _view(view), _mayPlanTurns(mayPlanTurns)
{
    if (boxes.empty()) return;
    _lower = boxes.front().lower;
    glm::ivec3 upper = boxes.front().upper;
    for (const BuildingBox& box : boxes)
    {
        _lower = glm::min(_lower, box.lower);
        upper = glm::max(upper, box.upper);
    }
    _size = upper - _lower;
    _isCovered = SparseBox<bool>(_size);
}

void StepViews::cover(const std::vector<std::uint32_t>& parts, bool isCovered)
{
    for (const std::uint32_t part : parts)
    {
        const BuildingBox& box = _boxes[part];
        for (int z = box.lower.z; z < box.upper.z; ++z)
            for (int y = box.lower.y; y < box.upper.y; ++y)
                for (int x = box.lower.x; x < box.upper.x; ++x)
                    _isCovered.edit(glm::ivec3(x, y, z) - _lower) = isCovered;
    }
}

int StepViews::show(const std::vector<std::uint32_t>& parts)
{
    cover(parts, true);
    Sight best = look(parts, _turns);
    if (best.numHidden == 0 && 2 * best.numVisible > parts.size()) return _turns;
    const int before = _turns;
    for (int turn = 1; turn < BuildingStep::NUM_TURNS; ++turn)
    {
        const int turns = (before + turn) % BuildingStep::NUM_TURNS;
        const Sight sight = look(parts, turns);
        if (std::pair(sight.numHidden, best.numVisible) >= std::pair(best.numHidden, sight.numVisible)) continue;
        best = sight;
        _turns = turns;
    }
    return _turns;
}

bool StepViews::canShow(const std::vector<std::uint32_t>& parts, bool isTurning)
{
    cover(parts, true);
    bool isShown = false;
    const int first = _mayPlanTurns ? _turns : 0;
    for (int turn = 0; turn < (isTurning && _mayPlanTurns ? BuildingStep::NUM_TURNS : 1) && !isShown; ++turn)
        isShown = look(parts, (first + turn) % BuildingStep::NUM_TURNS).numHidden == 0;
    cover(parts, false);
    return isShown;
}

StepViews::Sight StepViews::look(const std::vector<std::uint32_t>& parts, int turns) const
{
    constexpr double WELL = 0.25;
    constexpr double HARDLY = 0.125;
    const glm::dvec3 toEye = getDirection(_view, turns, _cellHeight);
    Sight sight;
    for (const std::uint32_t part : parts)
    {
        const double share = getVisibleShare(_boxes[part], toEye);
        if (share >= WELL) ++sight.numVisible;
        if (share < HARDLY) ++sight.numHidden;
    }
    return sight;
}

/** The share of the faces of a part's cells, those towards the eye and not grazing, that are visible. */
double StepViews::getVisibleShare(const BuildingBox& box, const glm::dvec3& toEye) const
{
    constexpr double OUTSIDE = 1e-3; // cells
    std::size_t numFaces = 0;
    std::size_t numVisible = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
        if (axis < 2 && isGrazing(toEye[axis])) continue; // along z, which counts layers, it is no cosine
        BuildingBox face = box;
        (toEye[axis] > 0.0 ? face.lower : face.upper)[axis] =
            toEye[axis] > 0.0 ? box.upper[axis] - 1 : box.lower[axis] + 1;
        glm::dvec3 middle(0.5);
        middle[axis] = toEye[axis] > 0.0 ? 1.0 + OUTSIDE : -OUTSIDE;
        for (int z = face.lower.z; z < face.upper.z; ++z)
            for (int y = face.lower.y; y < face.upper.y; ++y)
                for (int x = face.lower.x; x < face.upper.x; ++x, ++numFaces)
                    numVisible += isHidden(glm::dvec3(x, y, z) + middle, toEye) ? 0 : 1;
    }
    return static_cast<double>(numVisible) / static_cast<double>(numFaces);
}

/** Whether cells are between a place, in cells, and the eye. */
bool StepViews::isHidden(glm::dvec3 place, const glm::dvec3& toEye) const
{
    for (;;)
    {
        const glm::ivec3 cell(glm::floor(place));
        const bool isInside =
            glm::all(glm::greaterThanEqual(cell, _lower)) && glm::all(glm::lessThan(cell, _lower + _size));
        if (isInside && _isCovered.get(cell - _lower)) return true;
        double way = 0.0; // to the next cell
        int next = -1;
        for (int axis = 0; axis < 3; ++axis)
        {
            if (toEye[axis] == 0.0) continue;
            const double bound = toEye[axis] > 0.0 ? cell[axis] + 1.0 : cell[axis];
            const double length = (bound - place[axis]) / toEye[axis];
            if (next < 0 || length < way)
            {
                way = length;
                next = axis;
            }
        }
        constexpr double BEHIND = 1e-6; // the border of the cell
        place += (way + BEHIND) * toEye;
        // The eye is above, and beyond the border to which the ray leads.
        if (place.z >= _lower.z + _size.z) return false;
        if (toEye.x > 0.0 ? place.x >= _lower.x + _size.x : place.x < _lower.x) return false;
        if (toEye.y > 0.0 ? place.y >= _lower.y + _size.y : place.y < _lower.y) return false;
    }
}

} // namespace osgLego
