#include <osgLego/model/JoinSearch.h>

#include <osgLego/layout/PartSizes.h>

#include <algorithm>
#include <array>
#include <utility>

namespace osgLego
{

namespace
{

constexpr std::array<glm::ivec3, 2> UP_AND_DOWN{{{0, 0, 1}, {0, 0, -1}}};
/** The steps within a layer; the first two are along x. */
constexpr std::array<glm::ivec3, 4> SIDES{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}};
/** The number of cells of a piece that may be recoloured as a whole. */
constexpr std::size_t STRAY_CELLS = 2;

glm::ivec3 toCell(CellKey key)
{
    return {static_cast<int>(key & 0xffff), static_cast<int>(key >> 16 & 0xffff), static_cast<int>(key >> 32)};
}

double findPenalty(const std::unordered_map<CellKey, double>& penalties, const glm::ivec3& cell)
{
    const auto penalty = penalties.find(toCellKey(cell));
    return penalty == penalties.end() ? 0.0 : penalty->second;
}

} // namespace

std::optional<Join> JoinSearch::find(std::uint32_t piece)
{
    _piece = piece;
    _best.reset();
    _reached.clear();
    _open.clear();
    _extensible.clear();
    for (const glm::ivec3& cell : _map.getCells(piece))
        begin(cell);
    while (!_open.empty())
    {
        std::pop_heap(_open.begin(), _open.end());
        const Open open = _open.back();
        _open.pop_back();
        if (open.cost >= (_best ? _best->cost : LIMIT)) break;
        Reached& reached = _reached.at(open.state);
        if (std::exchange(reached.isDone, true)) continue;
        continueFrom(open.state);
    }
    return _best;
}

/** Enter the empty cells beside a cell of the piece, and joins to other pieces beside it. */
void JoinSearch::begin(const glm::ivec3& cell)
{
    Reached first;
    first.begin = cell;
    for (const glm::ivec3& step : UP_AND_DOWN)
        if (_map.isEmpty(cell + step))
        {
            first.cost = getCost(cell + step);
            reach({toCellKey(cell + step)}, first);
        }
    for (std::size_t side = 0; side < SIDES.size(); ++side)
    {
        const glm::ivec3 next = cell + SIDES[side];
        if (!mayExtend(_piece, side / 2)) continue;
        if (_map.isEmpty(next))
        {
            first.cost = BESIDE + getCost(next);
            reach({toCellKey(next), _map.getColor(cell), static_cast<std::uint8_t>(side / 2)}, first);
        }
        else if (isOfOther(next) && mayExtend(_map.getPiece(next), side / 2))
            joinBeside(cell, next);
    }
}

/** Join two cells that are beside each other, by another colour if need be. */
void JoinSearch::joinBeside(const glm::ivec3& cell, const glm::ivec3& other)
{
    Reached first;
    first.begin = cell;
    const std::uint16_t color = _map.getColor(cell);
    const std::uint16_t otherColor = _map.getColor(other);
    if (PartSizes::join(color, otherColor))
    {
        const double penalty = getPenaltyOfDirectStep(cell) + getPenaltyOfDirectStep(other);
        if (_map.mayBeConnected(cell, other)) finish(first, nullptr, other, std::nullopt, BESIDE + penalty);
        return;
    }
    recolor(first, nullptr, other, color, BESIDE);
    if (!mayBeRecolored(cell)) return;
    first.recolored = Join::Change{cell, otherColor};
    finish(first, nullptr, other, std::nullopt, BESIDE + getRecoloringCost(cell, otherColor));
}

void JoinSearch::continueFrom(const State& state)
{
    const Reached last = _reached.at(state);
    const glm::ivec3 cell = toCell(state.cell);
    Reached next = last;
    next.before = state;
    next.isFirst = false;
    next.isDone = false;
    for (const glm::ivec3& step : UP_AND_DOWN)
    {
        const glm::ivec3 other = cell + step;
        if (_map.isEmpty(other))
        {
            next.cost = last.cost + getCost(other);
            reach({toCellKey(other)}, next);
        }
        else if (isOfOther(other))
            finish(last, &state, other, std::nullopt, last.cost);
    }
    for (std::size_t side = 0; side < SIDES.size(); ++side)
    {
        const auto axis = static_cast<std::uint8_t>(side / 2);
        if (state.axis != NO_AXIS && state.axis != axis) continue;
        const glm::ivec3 other = cell + SIDES[side];
        if (_map.isEmpty(other))
        {
            next.cost = last.cost + BESIDE + getCost(other);
            reach({toCellKey(other), state.color, axis}, next);
            continue;
        }
        if (!isOfOther(other) || !mayExtend(_map.getPiece(other), axis)) continue;
        if (PartSizes::join(state.color, _map.getColor(other)))
            finish(last, &state, other, std::nullopt, last.cost + BESIDE);
        else
            recolor(last, &state, other, state.color, last.cost + BESIDE);
    }
}

/** End a path at a cell that gets another colour. */
void JoinSearch::recolor(const Reached& last, const State* state, const glm::ivec3& cell, std::uint16_t color,
                         double cost)
{
    if (mayBeRecolored(cell))
        finish(last, state, cell, Join::Change{cell, color}, cost + getRecoloringCost(cell, color));
}

void JoinSearch::reach(const State& state, Reached reached)
{
    if (reached.cost >= (_best ? _best->cost : LIMIT)) return;
    const auto [place, isNew] = _reached.try_emplace(state, reached);
    if (!isNew)
    {
        if (place->second.isDone || place->second.cost <= reached.cost) return;
        place->second = reached;
    }
    _open.push_back({reached.cost, state});
    std::push_heap(_open.begin(), _open.end());
}

void JoinSearch::finish(const Reached& last, const State* state, const glm::ivec3& end,
                        std::optional<Join::Change> recolored, double cost)
{
    if (cost >= (_best ? _best->cost : LIMIT)) return;
    Join join;
    join.begin = last.begin;
    join.end = end;
    join.cost = cost;
    for (const std::optional<Join::Change>& change : {last.recolored, recolored})
        if (change)
        {
            const std::vector<glm::ivec3>& cells = _map.getCells(_map.getPiece(change->cell));
            if (cells.size() > STRAY_CELLS)
                join.recolored.push_back(*change);
            else
                for (const glm::ivec3& cell : cells)
                    join.recolored.push_back({cell, change->color});
        }
    if (state)
        for (State at = *state;;)
        {
            join.added.push_back({toCell(at.cell), at.color});
            const Reached& reached = _reached.at(at);
            if (reached.isFirst) break;
            at = reached.before;
        }
    _best = std::move(join);
}

double JoinSearch::getCost(const glm::ivec3& cell)
{
    const auto [place, isNew] = _cellCosts.try_emplace(toCellKey(cell), 0.0);
    if (isNew) place->second = HIDDEN + EXPOSED * _exposure.get(cell) + getPenaltyOfChange(cell);
    return place->second;
}

double JoinSearch::getPenaltyOfChange(const glm::ivec3& cell) const
{
    return findPenalty(_penalties.changes, cell);
}

double JoinSearch::getPenaltyOfDirectStep(const glm::ivec3& cell) const
{
    return findPenalty(_penalties.directSteps, cell);
}

double JoinSearch::getRecoloringCost(const glm::ivec3& cell, std::uint16_t color) const
{
    const std::array<std::uint16_t, 3> place{static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y),
                                             static_cast<std::uint16_t>(cell.z)};
    return RECOLORING + DIFFERENCE * _costs.get(place, _map.getColor(cell), color) + getPenaltyOfChange(cell);
}

/** Whether a cell remains connected to its piece in another colour: by a cell above or below, or since the piece is
 * so small that all of it gets the colour. */
bool JoinSearch::mayBeRecolored(const glm::ivec3& cell)
{
    return _map.getCells(_map.getPiece(cell)).size() <= STRAY_CELLS || isInColumn(cell);
}

/** Whether the cell above or below a cell is covered. */
bool JoinSearch::isInColumn(const glm::ivec3& cell) const
{
    return std::any_of(UP_AND_DOWN.begin(), UP_AND_DOWN.end(),
                       [&](const glm::ivec3& step) { return _map.isCovered(cell + step); });
}

/** Whether a part that covers a cell of a piece and one beside it along an axis may join the piece. If no cell of the
 * piece has one above or below, the part must cover all of its cells: these are a row along the axis. */
bool JoinSearch::mayExtend(std::uint32_t piece, std::size_t axis)
{
    const auto [place, isNew] = _extensible.try_emplace(piece);
    if (!isNew) return place->second[axis];
    const std::vector<glm::ivec3>& cells = _map.getCells(piece);
    const bool isFlat =
        std::none_of(cells.begin(), cells.end(), [&](const glm::ivec3& cell) { return isInColumn(cell); });
    for (glm::length_t side = 0; side < 2; ++side)
    {
        const auto isInRow = [&](const glm::ivec3& cell) { return cell[1 - side] == cells.front()[1 - side]; };
        place->second[static_cast<std::size_t>(side)] = !isFlat || (cells.size() < std::size_t{PartSizes::LONGEST} &&
                                                                    std::all_of(cells.begin(), cells.end(), isInRow));
    }
    return place->second[axis];
}

/** Whether a cell belongs to a piece other than the one that is joined. */
bool JoinSearch::isOfOther(const glm::ivec3& cell)
{
    const std::uint32_t piece = _map.getPiece(cell);
    return piece != PieceMap::NONE && piece != _piece;
}

} // namespace osgLego
