#include <osgLego/building/ColumnSearch.h>

#include <osgLego/building/LayoutStanding.h>
#include <osgLego/data/UnionFind.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace osgLego
{

namespace
{

constexpr std::size_t MOST_COLUMNS = 64;
constexpr std::size_t MOST_REMOVALS = 16; // attempts: each computes the stability once

template <typename Item>
bool isLower(const Item& item, const Item& other)
{
    return std::tie(item.place[2], item.place[1], item.place[0]) <
           std::tie(other.place[2], other.place[1], other.place[0]);
}

void addCells(const LaidPart& part, std::vector<LayoutCell>& cells)
{
    for (int z = 0; z < part.size[2]; ++z)
        for (int y = 0; y < part.size[1]; ++y)
            for (int x = 0; x < part.size[0]; ++x)
                cells.push_back(
                    {{static_cast<std::uint16_t>(part.place[0] + x), static_cast<std::uint16_t>(part.place[1] + y),
                      static_cast<std::uint16_t>(part.place[2] + z)},
                     part.color});
}

/** A layout with columns. */
SupportedLayout addTo(const SupportedLayout& bare, const std::vector<SupportColumn>& columns)
{
    SupportedLayout layout = bare;
    for (const SupportColumn& column : columns)
    {
        const LaidParts parts = buildColumn(column, layout.problem.isOfPlates);
        for (const LaidPart& part : parts)
            addCells(part, layout.problem.cells);
        layout.parts.insert(layout.parts.end(), parts.begin(), parts.end());
        layout.numColumnParts += parts.size();
    }
    layout.numColumns = columns.size();
    std::sort(layout.parts.begin(), layout.parts.end(), isLower<LaidPart>);
    std::sort(layout.problem.cells.begin(), layout.problem.cells.end(), isLower<LayoutCell>);
    return layout;
}

/** Whether two parts have sides, or parts of them, in common. */
bool areTouching(const LaidPart& part, const LaidPart& other)
{
    int numGaps = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const int begin = std::max(part.place[axis], other.place[axis]);
        const int end = std::min(part.place[axis] + part.size[axis], other.place[axis] + other.size[axis]);
        if (begin > end) return false;
        if (begin == end) ++numGaps;
    }
    return numGaps <= 1;
}

/** Groups of parts that touch each other, the largest first. @param members indices of parts. */
std::vector<std::vector<std::uint32_t>> findGroups(const LaidParts& parts, const std::vector<std::uint32_t>& members)
{
    UnionFind sets;
    sets.reset(members.size());
    for (std::size_t i = 0; i < members.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (areTouching(parts[members[i]], parts[members[j]]))
                sets.join(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
    std::map<std::int32_t, std::vector<std::uint32_t>> byRoot;
    for (std::size_t i = 0; i < members.size(); ++i)
        byRoot[sets.find(static_cast<std::int32_t>(i))].push_back(members[i]);
    std::vector<std::vector<std::uint32_t>> groups;
    for (auto& [root, group] : byRoot)
        groups.push_back(std::move(group));
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& group, const auto& other) { return group.size() > other.size(); });
    return groups;
}

} // namespace

ColumnSearch::ColumnSearch(SupportedLayout& layout, StabilityReport& report, const std::function<bool()>& isCancelled) :
    _layout(layout), _report(report), _isCancelled(isCancelled), _bare(layout)
{
}

bool ColumnSearch::run()
{
    while (!_report.stands && _columns.size() < MOST_COLUMNS)
    {
        const std::size_t numColumns = _columns.size();
        if (!addBelowGroups()) return false;
        if (_columns.size() > numColumns) continue;
        if (!addBest(_report.falling)) return false;
        if (_columns.size() > numColumns) continue;
        // A model that tips over may need a column below parts other than those that can't be held.
        std::vector<std::uint32_t> all(_layout.parts.size());
        std::iota(all.begin(), all.end(), 0u);
        if (!addBest(all)) return false;
        if (_columns.size() == numColumns) break;
    }
    return !_report.stands || removeUnneeded();
}

bool ColumnSearch::addBelowGroups()
{
    std::vector<SupportColumn> columns = _columns;
    LayoutProblem problem = _layout.problem;
    for (const std::vector<std::uint32_t>& group : findGroups(_layout.parts, _report.falling))
    {
        const std::vector<SupportColumn> places = SupportColumns(problem, _layout.parts).find(group);
        if (places.empty() || columns.size() == MOST_COLUMNS) continue;
        columns.push_back(places.front());
        for (const LaidPart& part : buildColumn(columns.back(), problem.isOfPlates))
            addCells(part, problem.cells);
    }
    return columns.size() == _columns.size() || keepIfBetter(std::move(columns));
}

/** Add the column below some parts after which the fewest parts fall, if there is one that helps. */
bool ColumnSearch::addBest(const std::vector<std::uint32_t>& below)
{
    const std::vector<SupportColumn> present = _columns;
    for (const SupportColumn& column : SupportColumns(_layout.problem, _layout.parts).find(below))
    {
        std::vector<SupportColumn> columns = present;
        columns.push_back(column);
        if (!keepIfBetter(std::move(columns))) return false;
    }
    return true;
}

bool ColumnSearch::removeUnneeded()
{
    std::size_t numTries = 0;
    for (std::size_t index = _columns.size(); index-- > 0 && _columns.size() > 1 && numTries < MOST_REMOVALS;
         ++numTries)
    {
        std::vector<SupportColumn> columns = _columns;
        columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(index));
        SupportedLayout layout = addTo(_bare, columns);
        const std::optional<StabilityReport> report = computeStanding(layout.problem, layout.parts, _isCancelled);
        if (!report) return false;
        if (!report->stands) continue;
        _report = *report;
        _layout = std::move(layout);
        _columns = std::move(columns);
    }
    return true;
}

/** Exchange the columns for others if the model stands better then. @return false if it was cancelled. */
bool ColumnSearch::keepIfBetter(std::vector<SupportColumn> columns)
{
    SupportedLayout layout = addTo(_bare, columns);
    const std::optional<StabilityReport> report = computeStanding(layout.problem, layout.parts, _isCancelled);
    if (!report) return false;
    if (!standsBetter(*report, _report)) return true;
    _report = *report;
    _layout = std::move(layout);
    _columns = std::move(columns);
    return true;
}

} // namespace osgLego
