#include <osgLego/model/SupportBuilder.h>

#include <osgLego/model/ColumnSearch.h>
#include <osgLego/model/HiddenCells.h>
#include <osgLego/model/LayoutPieces.h>
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
constexpr std::array<int, 2> NUM_THICKENINGS{3, 1};
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
/** The fractions of progress after laying parts again, and after adding hidden cells. */
constexpr double LAID_AGAIN = 0.6;
constexpr double THICKENED = 0.8;

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

/** Count the pieces that reach the ground, and each other, through columns alone.
 * @param pieces those without columns, the largest first. */
std::size_t countPropped(const LayoutPieces& pieces, const SupportedLayout& layout)
{
    if (layout.columns.empty()) return 0;
    const LayoutPieces joined(layout.parts);
    const int ground = layout.problem.cells.front().place[2];
    const std::uint32_t main = joined.find(pieces.getCells(0).front());
    std::size_t count = 0;
    for (std::size_t piece = 1; piece < pieces.getCount(); ++piece)
    {
        const std::vector<glm::ivec3>& cells = pieces.getCells(piece);
        const bool isOnGround =
            std::any_of(cells.begin(), cells.end(), [&](const glm::ivec3& cell) { return cell.z == ground; });
        if (!isOnGround && joined.find(cells.front()) != main) ++count;
    }
    return count;
}

} // namespace

bool SupportBuilder::build(SupportedLayout& layout)
{
    const std::optional<StabilityReport> report = computeStanding(layout.problem, layout.parts, _options.isCancelled);
    if (!report) return false;
    _report = *report;
    if (!_report.stands && !layAgain(layout)) return false;
    if (!_report.stands && !thicken(layout)) return false;
    reportProgress(THICKENED);
    const LayoutPieces pieces(layout.parts);
    if (!_report.stands && !ColumnSearch(layout, _report, _options.isCancelled).run()) return false;
    layout.numPropped = countPropped(pieces, layout);
    layout.stands = _report.stands && layout.numPropped == 0;
    return true;
}

/** Lay parts near the weak ones again, and keep the best result. */
bool SupportBuilder::layAgain(SupportedLayout& layout)
{
    const int numAttempts = NUM_ATTEMPTS[layout.parts.size() < LARGE_MODEL ? 0 : 1];
    for (int attempt = 0; attempt < numAttempts && !_report.stands; ++attempt)
    {
        reportProgress(LAID_AGAIN * attempt / numAttempts);
        const LaidParts kept = removeNear(layout.parts, findWeakParts(_report), (attempt + 1) * REACH);
        LayoutOptions options = _options;
        options.bond = BOND;
        options.seed += SEED_STEP * static_cast<std::uint32_t>(attempt + 1);
        SupportedLayout other = layout;
        other.parts = layOut(layout.problem, options, kept);
        other.isLaidAgain = true;
        if (other.parts.empty() || !keepIfBetter(layout, std::move(other))) return false;
    }
    return true;
}

/** Add hidden cells near the weak parts, and keep the best result. */
bool SupportBuilder::thicken(SupportedLayout& layout)
{
    const int numAttempts = NUM_THICKENINGS[layout.parts.size() < LARGE_MODEL ? 0 : 1];
    for (int attempt = 0; attempt < numAttempts && !_report.stands; ++attempt)
    {
        reportProgress(LAID_AGAIN + (THICKENED - LAID_AGAIN) * attempt / numAttempts);
        const std::vector<std::uint32_t> weak = findWeakParts(_report);
        const std::vector<LayoutCell> added = findHiddenCells(layout.problem, layout.parts, weak, attempt + 1);
        if (added.empty()) continue;
        SupportedLayout other = layout;
        std::vector<LayoutCell>& cells = other.problem.cells;
        const auto middle = cells.insert(cells.end(), added.begin(), added.end());
        std::inplace_merge(cells.begin(), middle, cells.end(), isPlacedBefore<LayoutCell>);
        LayoutOptions options = _options;
        options.bond = BOND;
        other.parts = layOut(other.problem, options, removeNear(layout.parts, weak, attempt + 1 + REACH));
        other.isLaidAgain = true;
        other.numHiddenCells += added.size();
        if (other.parts.empty() || !keepIfBetter(layout, std::move(other))) return false;
    }
    return true;
}

void SupportBuilder::reportProgress(double fraction) const
{
    if (_progress) _progress(fraction);
}

/** Replace a layout by another one if that is more stable and has no more pieces. @return false if it was cancelled. */
bool SupportBuilder::keepIfBetter(SupportedLayout& layout, SupportedLayout&& other)
{
    const std::optional<StabilityReport> report = computeStanding(other.problem, other.parts, _options.isCancelled);
    if (!report) return false;
    if (!standsBetter(*report, _report)) return true;
    if (LayoutPieces(other.parts).getCount() > LayoutPieces(layout.parts).getCount()) return true;
    _report = *report;
    layout = std::move(other);
    return true;
}

} // namespace osgLego
