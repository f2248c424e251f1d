#include <osgLego/building/PartOrder.h>

#include <osgLego/building/BuildingRegions.h>
#include <osgLego/building/EarlyJoints.h>

#include <cstdlib>
#include <map>
#include <tuple>

namespace osgLego
{

namespace
{

constexpr std::size_t LONGEST_WALK = 2000; // parts; the time of a walk grows with the square of their number

} // namespace

PartOrder::PartOrder(const JointGraph& graph, const Symmetry& symmetry) :
    _boxes(graph.getBoxes()), _symmetry(symmetry), _ranks(_boxes.size(), 0), _groups(_boxes.size(), 0)
{
    const BuildingRegions regions(_boxes, symmetry);
    std::map<std::pair<std::uint32_t, int>, std::vector<std::uint32_t>> layers;
    for (std::uint32_t part = 0; part < _boxes.size(); ++part)
        layers[{regions.getRank(part), _boxes[part].lower.z}].push_back(part);
    glm::ivec3 place(0);
    std::vector<std::uint32_t> order;
    std::uint32_t group = 0;
    for (auto& [key, parts] : layers)
    {
        if (parts.size() <= LONGEST_WALK)
            walk(parts, place);
        else
            sortByBands(parts);
        for (const std::uint32_t part : parts)
            _groups[part] = group;
        order.insert(order.end(), parts.begin(), parts.end());
        ++group;
    }
    std::uint32_t rank = 0;
    for (const std::uint32_t part : joinEarly(graph, symmetry, order))
        _ranks[part] = rank++;
}

/** Sort parts along a walk, each time to the nearest part. @param place the start of the walk; receives its end. */
void PartOrder::walk(std::vector<std::uint32_t>& parts, glm::ivec3& place) const
{
    const auto toPlace = [this](std::uint32_t part) { return _symmetry.fold(_boxes[part].lower + _boxes[part].upper); };
    for (auto next = parts.begin(); next != parts.end(); ++next)
    {
        const auto distance = [&](std::uint32_t part)
        {
            const glm::ivec3 way = toPlace(part) - place;
            return std::pair(std::abs(way.x) + std::abs(way.y), part);
        };
        const auto nearest = std::min_element(
            next, parts.end(), [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); });
        std::rotate(next, nearest, nearest + 1);
        place = toPlace(*next);
        const auto twin = std::find(next + 1, parts.end(), _symmetry.getTwin(*next));
        if (twin == parts.end()) continue;
        ++next;
        std::rotate(next, twin, twin + 1);
    }
}

/** Sort many parts along bands, in alternate directions. */
void PartOrder::sortByBands(std::vector<std::uint32_t>& parts) const
{
    constexpr int BAND = 4; // studs
    const auto key = [this](std::uint32_t part)
    {
        const glm::ivec3& lower = _boxes[part].lower;
        const int band = lower.y / BAND;
        return std::tuple(band, band % 2 == 0 ? lower.x : -lower.x, lower.y);
    };
    std::sort(parts.begin(), parts.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
}

} // namespace osgLego
