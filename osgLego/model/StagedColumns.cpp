#include <osgLego/model/StagedColumns.h>

#include <osgLego/model/LayoutStanding.h>
#include <osgLego/model/PartGroups.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

namespace
{

// Groups of falling parts below which a column is tried, the largest first.
constexpr std::size_t MOST_GROUPS = 3;

} // namespace

bool StagedColumns::standWith(const Select& select, std::size_t mostCells)
{
    if (std::exchange(_mostCells, mostCells) != mostCells) _hopeless.clear();
    for (bool isAdded = true; isAdded;)
    {
        PartList falling;
        if (!findFalling(_layout, select, falling)) return false;
        if (falling.empty() || _hopeless.contains(falling)) return true;
        isAdded = false;
        PartGroups groups = findTouchingGroups(_layout.parts, falling);
        groups.resize(std::min(groups.size(), MOST_GROUPS));
        for (auto group = groups.begin(); group != groups.end() && !isAdded; ++group)
        {
            std::optional<SupportColumn> column;
            if (!findBelow(*group, select, falling.size(), column)) return false;
            if (!column) continue;
            SupportedLayout changed = addColumns(_layout, {*column});
            if (changed.problem.cells.size() > mostCells)
            {
                _hopeless.insert(std::move(falling));
                return false;
            }
            _layout = std::move(changed);
            _hopeless.clear();
            isAdded = true;
        }
        if (!isAdded) _hopeless.insert(std::move(falling));
    }
    return true;
}

/** Find the column after which the fewest parts fall, if one helps.
 * @param numFalling those that fall without it. @return false if it was cancelled. */
bool StagedColumns::findBelow(const PartList& group, const Select& select, std::size_t numFalling,
                              std::optional<SupportColumn>& best) const
{
    for (const SupportColumn& place : SupportColumns(_layout.problem, _layout.parts).find(group))
    {
        PartList falling;
        if (!findFalling(addColumns(_layout, {place}), select, falling)) return false;
        if (falling.size() >= numFalling) continue;
        numFalling = falling.size();
        best = place;
        if (numFalling == 0) break;
    }
    return true;
}

/** @param falling of the selected parts, indices in ascending order. @return false if it was cancelled. */
bool StagedColumns::findFalling(const SupportedLayout& layout, const Select& select, PartList& falling) const
{
    const PartList selected = select(layout.parts);
    LaidParts parts;
    parts.reserve(selected.size());
    for (const std::uint32_t part : selected)
        parts.push_back(layout.parts[part]);
    const std::optional<StabilityReport> report = computeStanding(layout.problem, parts, _isCancelled);
    if (!report) return false;
    for (const std::uint32_t part : report->falling)
        falling.push_back(selected[part]);
    return true;
}

} // namespace osgLego
