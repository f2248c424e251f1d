#include <osgLego/building/SupportBuilder.h>

#include <osgLego/building/LayoutStanding.h>
#include <osgLego/building/SupportColumns.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

namespace osgLego
{

namespace
{

/** Attempts to lay parts again, for small models and for others, whose stability takes long to compute. */
constexpr std::array<int, 2> NUM_ATTEMPTS{6, 2};
constexpr std::size_t LARGE_MODEL = 2000; // parts
/** Around weak parts, in cells: parts within it are laid again, in each attempt within more. */
constexpr int REACH = 3;
constexpr int BOND = 4; // the factor of the costs of stacked seams
/** Each attempt has random numbers of its own. */
constexpr std::uint32_t SEED_STEP = 0x9e3779b9u;
constexpr std::size_t MOST_COLUMNS = 64;

/** The parts that fall, or else those of the weakest joint. */
std::vector<std::uint32_t> findWeakParts(const StabilityReport& report)
{
    std::set<std::uint32_t> weak(report.falling.begin(), report.falling.end());
    if (report.weakest)
        for (const std::uint32_t part : {report.weakest->lower, report.weakest->upper})
            if (part != StabilityReport::Joint::BASE) weak.insert(part);
    return {weak.begin(), weak.end()};
}

bool isNear(const LaidPart& part, const LaidPart& other, int reach)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const int gap = std::max(part.place[axis] - (other.place[axis] + other.size[axis]),
                                 other.place[axis] - (part.place[axis] + part.size[axis]));
        if (gap >= reach) return false;
    }
    return true;
}

/** The parts that are not near weak ones. */
LaidParts removeNear(const LaidParts& parts, const std::vector<std::uint32_t>& weak, int reach)
{
    LaidParts rest;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(rest),
                 [&](const LaidPart& part)
                 {
                     return std::none_of(weak.begin(), weak.end(),
                                         [&](std::uint32_t index) { return isNear(part, parts[index], reach); });
                 });
    return rest;
}

bool isBefore(const std::array<std::uint16_t, 3>& place, const std::array<std::uint16_t, 3>& other)
{
    return std::array{place[2], place[1], place[0]} < std::array{other[2], other[1], other[0]};
}

/** Add a column to a layout. */
void add(const LaidParts& column, SupportedLayout& layout)
{
    for (const LaidPart& part : column)
    {
        layout.parts.push_back(part);
        for (int z = 0; z < part.size[2]; ++z)
            for (int y = 0; y < part.size[1]; ++y)
                for (int x = 0; x < part.size[0]; ++x)
                    layout.problem.cells.push_back(
                        {{static_cast<std::uint16_t>(part.place[0] + x), static_cast<std::uint16_t>(part.place[1] + y),
                          static_cast<std::uint16_t>(part.place[2] + z)},
                         part.color});
    }
    const auto isLower = [](const auto& item, const auto& other) { return isBefore(item.place, other.place); };
    std::sort(layout.parts.begin(), layout.parts.end(), isLower);
    std::sort(layout.problem.cells.begin(), layout.problem.cells.end(), isLower);
    ++layout.numColumns;
    layout.numColumnParts += column.size();
}

} // namespace

std::optional<StabilityReport> SupportBuilder::compute(const LayoutProblem& problem, const LaidParts& parts) const
{
    return computeStanding(problem, parts, _options.isCancelled);
}

bool SupportBuilder::build(SupportedLayout& layout)
{
    const std::optional<StabilityReport> report = compute(layout.problem, layout.parts);
    if (!report) return false;
    _report = *report;
    if (!_report.stands && !layAgain(layout)) return false;
    if (!_report.stands && !addColumns(layout)) return false;
    layout.stands = _report.stands;
    return true;
}

/** Lay parts near the weak ones again, and keep the best result. */
bool SupportBuilder::layAgain(SupportedLayout& layout)
{
    const int numAttempts = NUM_ATTEMPTS[layout.parts.size() < LARGE_MODEL ? 0 : 1];
    for (int attempt = 0; attempt < numAttempts && !_report.stands; ++attempt)
    {
        const LaidParts kept = removeNear(layout.parts, findWeakParts(_report), (attempt + 1) * REACH);
        LayoutOptions options = _options;
        options.progress = nullptr;
        options.bond = BOND;
        options.seed += SEED_STEP * static_cast<std::uint32_t>(attempt + 1);
        LaidParts parts = layOut(layout.problem, options, kept);
        if (parts.empty()) return false;
        const std::optional<StabilityReport> report = compute(layout.problem, parts);
        if (!report) return false;
        if (!standsBetter(*report, _report)) continue;
        _report = *report;
        layout.parts = std::move(parts);
        layout.isLaidAgain = true;
    }
    return true;
}

bool SupportBuilder::addColumns(SupportedLayout& layout)
{
    while (!_report.stands && layout.numColumns < MOST_COLUMNS)
    {
        const std::size_t numColumns = layout.numColumns;
        if (!addBestColumn(layout, _report.falling)) return false;
        if (layout.numColumns > numColumns) continue;
        // A model that tips over may need a column below parts other than those that can't be held.
        std::vector<std::uint32_t> all(layout.parts.size());
        std::iota(all.begin(), all.end(), 0u);
        if (!addBestColumn(layout, all)) return false;
        if (layout.numColumns == numColumns) break;
    }
    return true;
}

/** Add the column below some parts after which the fewest parts fall, if there is one that helps.
 * @return false if it was cancelled. */
bool SupportBuilder::addBestColumn(SupportedLayout& layout, const std::vector<std::uint32_t>& below)
{
    const SupportColumns columns(layout.problem, layout.parts);
    std::optional<SupportedLayout> best;
    StabilityReport bestReport = _report;
    for (const SupportColumn& column : columns.find(below))
    {
        SupportedLayout candidate = layout;
        add(columns.build(column), candidate);
        const std::optional<StabilityReport> report = compute(candidate.problem, candidate.parts);
        if (!report) return false;
        if (!standsBetter(*report, bestReport)) continue;
        bestReport = *report;
        best = std::move(candidate);
    }
    if (!best) return true;
    layout = std::move(*best);
    _report = bestReport;
    return true;
}

} // namespace osgLego
