#include <osgLego/model/ColumnSearch.h>

#include <osgLego/data/CellKeys.h>
#include <osgLego/data/UnionFind.h>
#include <osgLego/model/LaidBox.h>
#include <osgLego/model/LayoutStanding.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace osgLego
{

namespace
{

constexpr std::size_t MOST_COLUMNS = 64;
constexpr std::size_t MOST_REMOVALS = 16; // attempts: each computes the stability once

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
    std::sort(layout.parts.begin(), layout.parts.end(), isPlacedBefore<LaidPart>);
    std::sort(layout.problem.cells.begin(), layout.problem.cells.end(), isPlacedBefore<LayoutCell>);
    return layout;
}

/** Groups of parts that touch each other, the largest first. @param members indices of parts. */
std::vector<std::vector<std::uint32_t>> findGroups(const LaidParts& parts, const std::vector<std::uint32_t>& members)
{
    std::unordered_map<CellKey, std::int32_t> cells;
    for (std::size_t i = 0; i < members.size(); ++i)
        visitCells(toBox(parts[members[i]]),
                   [&](const glm::ivec3& cell) { cells.emplace(toCellKey(cell), static_cast<std::int32_t>(i)); });
    UnionFind sets;
    sets.reset(members.size());
    for (const auto& [key, member] : cells)
        for (const CellKey step : {CELL_RIGHT, CELL_BEHIND, CELL_ABOVE})
            if (const auto next = cells.find(key + step); next != cells.end()) sets.join(member, next->second);
    std::map<std::int32_t, std::vector<std::uint32_t>> byRoot;
    for (std::size_t i = 0; i < members.size(); ++i)
        byRoot[sets.find(static_cast<std::int32_t>(i))].push_back(members[i]);
    std::vector<std::vector<std::uint32_t>> groups;
    groups.reserve(byRoot.size());
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
        // A model that tips over may need a column below parts other than the falling ones.
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
    SupportColumns places(_layout.problem, _layout.parts);
    for (const std::vector<std::uint32_t>& group : findGroups(_layout.parts, _report.falling))
    {
        if (columns.size() == MOST_COLUMNS) break;
        const std::vector<SupportColumn> found = places.find(group);
        if (found.empty()) continue;
        columns.push_back(found.front());
        places.add(found.front());
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

/** Replace the columns by others if the model is more stable then. @return false if it was cancelled. */
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
