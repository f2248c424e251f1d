#include <osgLego/stability/JointGraph.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

namespace
{

/** A column of a part, sorted by place and height. */
struct PartColumn
{
    std::uint64_t key = 0;
    std::uint32_t part = 0;

    bool operator<(const PartColumn& other) const { return key < other.key; }
};

constexpr int COORDINATE_BITS = 16;

std::uint64_t toPair(std::uint32_t from, std::uint32_t to)
{
    return static_cast<std::uint64_t>(from) << 32 | to;
}

std::vector<PartColumn> sortColumns(const std::vector<BuildingBox>& boxes)
{
    std::vector<PartColumn> columns;
    for (std::uint32_t part = 0; part < boxes.size(); ++part)
    {
        const BuildingBox& box = boxes[part];
        for (int y = box.lower.y; y < box.upper.y; ++y)
            for (int x = box.lower.x; x < box.upper.x; ++x)
            {
                const std::uint64_t place = static_cast<std::uint64_t>(y) << COORDINATE_BITS | static_cast<unsigned>(x);
                columns.push_back({place << COORDINATE_BITS | static_cast<unsigned>(box.lower.z), part});
            }
    }
    std::sort(columns.begin(), columns.end());
    return columns;
}

} // namespace

void JointGraph::Lists::build(std::size_t numParts, const std::vector<std::uint64_t>& pairs)
{
    _starts.assign(numParts + 1, 0);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        if (i > 0 && pairs[i] == pairs[i - 1])
        {
            ++_links.back().studs;
            continue;
        }
        ++_starts[(pairs[i] >> 32) + 1];
        _links.push_back({static_cast<std::uint32_t>(pairs[i]), 1});
    }
    for (std::size_t part = 0; part < numParts; ++part)
        _starts[part + 1] += _starts[part];
}

JointGraph::JointGraph(std::vector<BuildingBox> boxes) : _boxes(std::move(boxes))
{
    if (!_boxes.empty()) _lowestLayer = _boxes.front().lower.z;
    for (const BuildingBox& box : _boxes)
        _lowestLayer = std::min(_lowestLayer, box.lower.z);
    std::vector<std::uint64_t> joints;
    std::vector<std::uint64_t> neighbors;
    const std::vector<PartColumn> columns = sortColumns(_boxes);
    for (std::size_t i = 1; i < columns.size(); ++i)
    {
        if (columns[i].key >> COORDINATE_BITS != columns[i - 1].key >> COORDINATE_BITS) continue;
        const std::uint32_t low = columns[i - 1].part;
        const std::uint32_t high = columns[i].part;
        neighbors.push_back(toPair(low, high));
        if (_boxes[low].upper.z == _boxes[high].lower.z) joints.push_back(neighbors.back());
    }
    const auto build = [this](std::vector<std::uint64_t>& pairs, Lists& fromLow, Lists& fromHigh)
    {
        std::sort(pairs.begin(), pairs.end());
        fromLow.build(_boxes.size(), pairs);
        for (std::uint64_t& pair : pairs)
            pair = pair << 32 | pair >> 32;
        std::sort(pairs.begin(), pairs.end());
        fromHigh.build(_boxes.size(), pairs);
    };
    build(joints, _jointsAbove, _jointsBelow);
    build(neighbors, _nextAbove, _nextBelow);
}

} // namespace osgLego
