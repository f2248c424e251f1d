#include <osgLego/model/ColumnSearch.h>

#include <osgLego/model/LayoutStanding.h>
#include <osgLego/model/PartGroups.h>

#include <numeric>
#include <optional>
#include <utility>

namespace osgLego
{

namespace
{

constexpr std::size_t MOST_COLUMNS = 64;
constexpr std::size_t MOST_REMOVALS = 16; // attempts: each computes the stability once

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
    for (const std::vector<std::uint32_t>& group : findTouchingGroups(_layout.parts, _report.falling))
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
        SupportedLayout layout = addColumns(_bare, columns);
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
    SupportedLayout layout = addColumns(_bare, columns);
    const std::optional<StabilityReport> report = computeStanding(layout.problem, layout.parts, _isCancelled);
    if (!report) return false;
    if (!standsBetter(*report, _report)) return true;
    _report = *report;
    _layout = std::move(layout);
    _columns = std::move(columns);
    return true;
}

} // namespace osgLego
