#include <osgLego/model/ConnectionBuilder.h>

#include <osgLego/model/JoinPruning.h>
#include <osgLego/model/JoinSearch.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

namespace osgLego
{

namespace
{

/** The additional cost of cells that did not help. */
constexpr double PENALTY = 2.0;
/** The distance from changed cells within which parts are laid again, in cells: sideways, and up or down. */
constexpr glm::ivec3 REACH{3, 3, 1};
/** The difference of the seeds of two rounds. */
constexpr std::uint32_t SEED_OF_ROUND = 0x85ebca6bu;

glm::ivec3 toVector(const std::array<std::uint16_t, 3>& place)
{
    return {place[0], place[1], place[2]};
}

LayoutCell toLayoutCell(const glm::ivec3& cell)
{
    return {
        {static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y), static_cast<std::uint16_t>(cell.z)}};
}

/** The cells that joins add or change, or that need another part: one that also covers a cell beside it. */
std::vector<glm::ivec3> collectChanged(const std::vector<Join>& joins)
{
    std::vector<glm::ivec3> cells;
    for (const Join& join : joins)
    {
        for (const std::vector<Join::Change>* changes : {&join.added, &join.recolored})
            for (const Join::Change& change : *changes)
                cells.push_back(change.cell);
        const bool isDirect = join.added.empty();
        if (isDirect || join.added.back().cell.z == join.begin.z) cells.push_back(join.begin);
        if (isDirect || join.added.front().cell.z == join.end.z) cells.push_back(join.end);
    }
    return cells;
}

/** The cells with the changes of some joins. */
LayoutProblem applyJoins(const std::vector<Join>& joins, const LayoutProblem& problem)
{
    LayoutProblem changed = problem;
    for (const Join& join : joins)
        for (const Join::Change& change : join.recolored)
        {
            const auto cell = std::lower_bound(changed.cells.begin(), changed.cells.end(), toLayoutCell(change.cell),
                                               isPlacedBefore<LayoutCell>);
            cell->color = change.color;
        }
    for (const Join& join : joins)
        for (const Join::Change& change : join.added)
            changed.cells.push_back(toLayoutCell(change.cell));
    std::sort(changed.cells.begin(), changed.cells.end(), isPlacedBefore<LayoutCell>);
    // Two joins may have a cell in common.
    const auto isSame = [](const LayoutCell& cell, const LayoutCell& other) { return cell.place == other.place; };
    changed.cells.erase(std::unique(changed.cells.begin(), changed.cells.end(), isSame), changed.cells.end());
    return changed;
}

bool isNear(const LaidPart& part, const glm::ivec3& cell, const glm::ivec3& reach)
{
    const glm::ivec3 lower = toVector(part.place);
    for (int axis = 0; axis < 3; ++axis)
    {
        const int last = lower[axis] + part.size[static_cast<std::size_t>(axis)] - 1;
        if (lower[axis] - cell[axis] > reach[axis] || cell[axis] - last > reach[axis]) return false;
    }
    return true;
}

/** The parts that are not within reach of any of the cells. */
LaidParts keepOthers(const LaidParts& parts, const std::vector<glm::ivec3>& cells, const glm::ivec3& reach)
{
    LaidParts kept;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(kept),
                 [&](const LaidPart& part)
                 {
                     return std::none_of(cells.begin(), cells.end(),
                                         [&](const glm::ivec3& cell) { return isNear(part, cell, reach); });
                 });
    return kept;
}

/** @param cells some of the others, in another colour or not. */
std::vector<glm::ivec3> findRecolored(const std::vector<LayoutCell>& cells, const std::vector<LayoutCell>& others)
{
    std::vector<glm::ivec3> recolored;
    auto other = others.begin();
    for (const LayoutCell& cell : cells)
    {
        while (other->place != cell.place)
            ++other;
        if (other->color != cell.color) recolored.push_back(toVector(cell.place));
    }
    return recolored;
}

bool hasFailed(const Join& join, const LayoutPieces& pieces)
{
    return pieces.find(join.begin) != pieces.find(join.end);
}

auto countFailed(const std::vector<Join>& joins, const LayoutPieces& pieces)
{
    return std::count_if(joins.begin(), joins.end(), [&](const Join& join) { return hasFailed(join, pieces); });
}

} // namespace

ConnectionBuilder::ConnectionBuilder(const LayoutOptions& options, const RecoloringCosts& costs) :
    _progress(options.progress), _options(options), _costs(costs)
{
    _options.progress = nullptr;
    _roundOptions = _options;
    _roundOptions.effort = std::min(_options.effort, Effort::NORMAL);
}

bool ConnectionBuilder::build(JoinedLayout& layout)
{
    _statistics = {};
    _statistics.numPieces = _statistics.numPiecesBefore = LayoutPieces(layout.parts).getCount();
    const std::vector<LayoutCell> cells = layout.problem.cells;
    // Studs join no parts of a single layer: changed colours would only make fewer and larger ones of them.
    if (layout.problem.size.z == 1) return true;
    if (!joinPieces(layout, false)) return false;
    // Where no join has failed, the same ones would be found.
    if (!_penalties.isEmpty() && !joinPieces(layout, true)) return false;
    removeUnneededCells(layout);
    const std::vector<glm::ivec3> recolored = findRecolored(cells, layout.problem.cells);
    if (_options.effort > _roundOptions.effort && !improve(layout, recolored)) return false;
    _statistics.numAddedCells = layout.added.size();
    _statistics.numRecolored = recolored.size();
    _statistics.numPieces = LayoutPieces(layout.parts).getCount();
    return true;
}

/** Join pieces in rounds.
 * @param joinsOthers whether to go on from layouts in which all joins hold, but as many other parts came loose.
 * @return false if it was cancelled. */
bool ConnectionBuilder::joinPieces(JoinedLayout& layout, bool joinsOthers)
{
    _penalties = {};
    LayoutPieces pieces(layout.parts);
    std::optional<JoinedLayout> best; // if it is not this layout
    for (int numFailures = 0; pieces.getCount() > 1 && numFailures < MOST_FAILURES;)
    {
        const std::vector<Join> joins = findJoins(layout, pieces);
        if (isCancelled()) return false;
        if (joins.empty()) break;
        std::optional<JoinedLayout> joined = layAgain(layout, joins, numFailures % 2 == 0 ? glm::ivec3(0) : REACH);
        if (!joined) return false;
        LayoutPieces found(joined->parts);
        const bool isBetter = found.getCount() < pieces.getCount();
        numFailures = isBetter ? 0 : numFailures + 1;
        penalizeFailed(joins, found, isBetter, PENALTY * std::max(numFailures, 1));
        const bool isOther = joinsOthers && found.getCount() == pieces.getCount() && countFailed(joins, found) == 0;
        if (!isBetter && !isOther) continue;
        if (isBetter)
            best.reset();
        else if (!best)
            best = std::move(layout);
        layout = std::move(*joined);
        pieces = std::move(found);
        if (isBetter && _progress)
            _progress(1.0 - static_cast<double>(pieces.getCount()) / static_cast<double>(_statistics.numPiecesBefore));
    }
    if (best) layout = std::move(*best);
    return true;
}

/** Lay the parts near all changed cells again, with all of the effort, if fewer pieces or parts result.
 * @param changed the cells in another colour.
 * @return false if it was cancelled. */
bool ConnectionBuilder::improve(JoinedLayout& layout, std::vector<glm::ivec3> changed)
{
    changed.insert(changed.end(), layout.added.begin(), layout.added.end());
    if (changed.empty()) return true;
    LaidParts parts = layOut(layout.problem, _options, keepOthers(layout.parts, changed, REACH));
    if (parts.empty()) return false;
    const auto rank = [](const LaidParts& some) { return std::pair(LayoutPieces(some).getCount(), some.size()); };
    if (rank(parts) < rank(layout.parts)) layout.parts = std::move(parts);
    return true;
}

/** Lay the parts near some joins again. @return nothing if it was cancelled. */
std::optional<JoinedLayout> ConnectionBuilder::layAgain(const JoinedLayout& layout, const std::vector<Join>& joins,
                                                        const glm::ivec3& reach)
{
    _roundOptions.seed += SEED_OF_ROUND;
    JoinedLayout joined{applyJoins(joins, layout.problem), {}, layout.added};
    joined.parts = layOut(joined.problem, _roundOptions, keepOthers(layout.parts, collectChanged(joins), reach));
    if (joined.parts.empty()) return std::nullopt;
    for (const Join& join : joins)
        for (const Join::Change& change : join.added)
            joined.added.push_back(change.cell);
    return joined;
}

/** Make joins more expensive that did not join their pieces. If all did, but other parts came loose, all of them. */
void ConnectionBuilder::penalizeFailed(const std::vector<Join>& joins, const LayoutPieces& pieces, bool isBetter,
                                       double penalty)
{
    const bool isAny = isBetter || countFailed(joins, pieces) > 0;
    for (const Join& join : joins)
        if (!isAny || hasFailed(join, pieces)) penalize(join, penalty);
}

/** Make the cells of a join more expensive, and direct steps where parts were laid again in vain. */
void ConnectionBuilder::penalize(const Join& join, double penalty)
{
    for (const std::vector<Join::Change>* changes : {&join.added, &join.recolored})
        for (const Join::Change& change : *changes)
            _penalties.changes[toCellKey(change.cell)] += penalty;
    for (int y = -REACH.y; y <= REACH.y; ++y)
        for (int x = -REACH.x; x <= REACH.x; ++x)
            _penalties.directSteps[toCellKey(join.begin + glm::ivec3(x, y, 0))] += penalty;
}

/** The cheapest joins after which all pieces that can be joined are one, the smallest pieces first. */
std::vector<Join> ConnectionBuilder::findJoins(const JoinedLayout& layout, const LayoutPieces& pieces) const
{
    PieceMap map(layout.problem, pieces);
    const CellExposure exposure(layout.problem);
    JoinSearch search(map, exposure, _costs, _penalties);
    std::vector<Join> joins;
    for (auto piece = static_cast<std::uint32_t>(pieces.getCount() - 1); piece > 0 && !isCancelled(); --piece)
    {
        if (map.getUnion(piece) == map.getUnion(0)) continue;
        std::optional<Join> join = search.find(map.getUnion(piece));
        if (!join) continue;
        map.add(*join);
        joins.push_back(std::move(*join));
    }
    return joins;
}

} // namespace osgLego
