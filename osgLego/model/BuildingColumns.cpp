#include <osgLego/model/BuildingColumns.h>

#include <osgLego/model/LayoutStanding.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

namespace
{

// The share of the parts that the best place supports, with which another place counts as equally good.
constexpr double NEARLY_BEST = 0.8;
// The share of a group that a column has to support to be worth its look.
constexpr double LEAST_SHARE = 0.15;
// The share of the largest group that may be left. Columns that leave more are not worth their look.
constexpr double MOST_LEFT = 0.6;

} // namespace

BuildingColumns::BuildingColumns(SupportedLayout& layout, const std::function<bool()>& isCancelled,
                                 std::size_t mostHanging) :
    _layout(layout),
    _isCancelled(isCancelled), _mostHanging(mostHanging), _places(layout.problem, layout.parts), _hanging(layout.parts),
    _numHanging(_hanging.getCount())
{
}

bool BuildingColumns::run()
{
    std::vector<SupportColumn> columns;
    std::size_t first = 0;
    std::size_t rest = 0;
    while (true)
    {
        if (_isCancelled && _isCancelled()) return false;
        const std::vector<std::vector<std::uint32_t>> groups = _hanging.getGroups();
        rest = groups.empty() ? 0 : groups.front().size();
        if (columns.empty()) first = rest;
        if (rest <= _mostHanging || columns.size() == MOST_COLUMNS) break;
        const std::optional<SupportColumn> column = findBelow(groups.front());
        if (!column) break;
        columns.push_back(*column);
        carry(*column);
    }
    if (columns.empty() || static_cast<double>(rest) > MOST_LEFT * static_cast<double>(first)) return true;
    return keep(columns);
}

/** Choose a column below a group of hanging parts. @return nothing if no column supports many of them. */
std::optional<SupportColumn> BuildingColumns::findBelow(const std::vector<std::uint32_t>& group) const
{
    const SupportColumns::Filter filter = [this](const SupportColumn& column) { return standsOnGround(column); };
    std::vector<std::pair<std::size_t, std::uint32_t>> places;
    std::size_t most = 0;
    for (const std::uint32_t part : group)
    {
        if (!_places.hasPlace(part, filter)) continue;
        places.emplace_back(_hanging.findAbove(part).size(), part);
        most = std::max(most, places.back().first);
    }
    if (static_cast<double>(most) < LEAST_SHARE * static_cast<double>(group.size())) return {};
    std::vector<std::uint32_t> good;
    for (const auto& [count, part] : places)
        if (static_cast<double>(count) >= NEARLY_BEST * static_cast<double>(most)) good.push_back(part);
    const std::vector<SupportColumn> found = _places.find(good, filter);
    return found.empty() ? std::nullopt : std::optional(found.front());
}

/** Whether no cell below a column belongs to a hanging part. */
bool BuildingColumns::standsOnGround(const SupportColumn& column) const
{
    for (int y = 0; y < column.width; ++y)
        for (int x = 0; x < column.width; ++x)
            if (_hanging.isAt(column.place + glm::ivec3(x, y, -1))) return false;
    return true;
}

/** Have a column support the parts above it. */
void BuildingColumns::carry(const SupportColumn& column)
{
    _places.add(column);
    for (int y = 0; y < column.width; ++y)
        for (int x = 0; x < column.width; ++x)
            _hanging.supportAt(column.place + glm::ivec3(x, y, column.height));
}

/** Add columns if the model stands with them. @return false if it was cancelled. */
bool BuildingColumns::keep(const std::vector<SupportColumn>& columns)
{
    SupportedLayout layout = addColumns(_layout, columns);
    const std::optional<StabilityReport> report = computeStanding(layout.problem, layout.parts, _isCancelled);
    if (!report) return false;
    if (!report->stands) return true;
    layout.numCarried = _numHanging - _hanging.getCount();
    _layout = std::move(layout);
    return true;
}

} // namespace osgLego
