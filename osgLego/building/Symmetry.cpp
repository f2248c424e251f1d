#include <osgLego/building/Symmetry.h>

#include <osgLego/data/CellKeys.h>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr double LEAST_SHARE = 0.9;

BuildingBox mirrorAt(BuildingBox box, int axis, int sum)
{
    const int lower = box.lower[axis];
    box.lower[axis] = sum - box.upper[axis];
    box.upper[axis] = sum - lower;
    return box;
}

double measure(const std::vector<BuildingBox>& boxes, const std::vector<CellKey>& cells, int axis, int sum)
{
    std::size_t numMirrored = 0;
    for (const BuildingBox& box : boxes)
        visitCells(mirrorAt(box, axis, sum), [&](const glm::ivec3& cell)
                   { numMirrored += std::binary_search(cells.begin(), cells.end(), toCellKey(cell)) ? 1 : 0; });
    return static_cast<double>(numMirrored) / static_cast<double>(cells.size());
}

} // namespace

Symmetry::Symmetry(const std::vector<BuildingBox>& boxes) : _twins(boxes.size(), NONE)
{
    if (boxes.empty()) return;
    findPlane(boxes);
    if (hasPlane()) findTwins(boxes);
}

void Symmetry::findPlane(const std::vector<BuildingBox>& boxes)
{
    BuildingBox bounds = boxes.front();
    std::vector<CellKey> cells;
    for (const BuildingBox& box : boxes)
    {
        bounds = {glm::min(bounds.lower, box.lower), glm::max(bounds.upper, box.upper)};
        visitCells(box, [&](const glm::ivec3& cell) { cells.push_back(toCellKey(cell)); });
    }
    std::sort(cells.begin(), cells.end());
    double best = LEAST_SHARE;
    for (const int axis : {0, 1})
    {
        const int sum = bounds.lower[axis] + bounds.upper[axis];
        const double share = measure(boxes, cells, axis, sum);
        if (share < best || (hasPlane() && share == best)) continue;
        best = share;
        _axis = axis;
        _sum = sum;
    }
}

void Symmetry::findTwins(const std::vector<BuildingBox>& boxes)
{
    std::vector<std::pair<CellKey, std::uint32_t>> places;
    places.reserve(boxes.size());
    for (std::uint32_t part = 0; part < boxes.size(); ++part)
        places.emplace_back(toCellKey(boxes[part].lower), part);
    std::sort(places.begin(), places.end());
    for (std::uint32_t part = 0; part < boxes.size(); ++part)
    {
        const BuildingBox wanted = mirror(boxes[part]);
        const auto place = std::lower_bound(places.begin(), places.end(), std::pair(toCellKey(wanted.lower), 0u));
        if (place != places.end() && place->second != part && boxes[place->second] == wanted)
            _twins[part] = place->second;
    }
}

BuildingBox Symmetry::mirror(BuildingBox box) const
{
    return hasPlane() ? mirrorAt(box, _axis, _sum) : box;
}

glm::ivec3 Symmetry::fold(glm::ivec3 place) const
{
    if (hasPlane()) place[_axis] = std::abs(place[_axis] - _sum);
    return place;
}

} // namespace osgLego
