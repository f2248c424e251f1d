#include <osgLego/model/SupportBuilder.h>

#include <osgLego/model/ColumnSearch.h>
#include <osgLego/model/LayoutStanding.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace osgLego
{

namespace
{

/** The number of attempts to lay parts again, for small and for large models; the stability of large ones takes long to
 * compute. */
constexpr std::array<int, 2> NUM_ATTEMPTS{6, 2};
constexpr std::size_t LARGE_MODEL = 2000; // parts
/** The distance from weak parts within which parts are laid again, in cells; each attempt adds to it. */
constexpr int REACH = 3;
constexpr int BOND = 4; // the factor of the costs of stacked seams
/** The largest number of weak parts near which parts are laid again. If more parts fall, laying parts again rarely
 * helps.
 */
constexpr std::size_t MOST_WEAK_PARTS = 256;
/** The difference of the seeds of two attempts. */
constexpr std::uint32_t SEED_STEP = 0x9e3779b9u;

/** The falling parts, and those of the weakest joint. */
std::vector<std::uint32_t> findWeakParts(const StabilityReport& report)
{
    std::set<std::uint32_t> weak(report.falling.begin(), report.falling.end());
    if (report.weakest)
        for (const std::uint32_t part : {report.weakest->lower, report.weakest->upper})
            if (part != StabilityReport::Joint::BASE) weak.insert(part);
    std::vector<std::uint32_t> parts(weak.begin(), weak.end());
    parts.resize(std::min(parts.size(), MOST_WEAK_PARTS));
    return parts;
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

} // namespace

bool SupportBuilder::build(SupportedLayout& layout)
{
    const std::optional<StabilityReport> report = computeStanding(layout.problem, layout.parts, _options.isCancelled);
    if (!report) return false;
    _report = *report;
    if (!_report.stands && !layAgain(layout)) return false;
    if (!_report.stands && !ColumnSearch(layout, _report, _options.isCancelled).run()) return false;
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
        const std::optional<StabilityReport> report = computeStanding(layout.problem, parts, _options.isCancelled);
        if (!report) return false;
        if (!standsBetter(*report, _report)) continue;
        _report = *report;
        layout.parts = std::move(parts);
        layout.isLaidAgain = true;
    }
    return true;
}

} // namespace osgLego
