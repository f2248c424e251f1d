#include <osgLego/model/PieceMap.h>

#include <osgLego/layout/PossibleComponents.h>

namespace osgLego
{

PieceMap::PieceMap(const LayoutProblem& problem, const LayoutPieces& pieces) :
    _size(problem.size), _ground(problem.cells.empty() ? 0 : problem.cells.front().place[2])
{
    _cells.reserve(problem.cells.size());
    _members.resize(pieces.getCount());
    _components.resize(pieces.getCount(), NO_COMPONENT);
    const std::vector<std::int32_t> components = findPossibleComponents(problem);
    for (std::size_t index = 0; index < problem.cells.size(); ++index)
    {
        const LayoutCell& cell = problem.cells[index];
        const glm::ivec3 place(cell.place[0], cell.place[1], cell.place[2]);
        const std::uint32_t piece = pieces.find(place);
        _cells.emplace(toCellKey(place), Cell{cell.color, piece});
        _members[piece].push_back(place);
        // A piece is connected, so all its columns are in one possible component.
        if (components[index] != NO_COMPONENT) _components[piece] = components[index];
    }
    _unions.reset(pieces.getCount());
}

bool PieceMap::isEmpty(const glm::ivec3& cell) const
{
    for (int axis = 0; axis < 3; ++axis)
        if (cell[axis] < 0 || cell[axis] >= _size[axis]) return false;
    return cell.z >= _ground && !isCovered(cell);
}

std::uint32_t PieceMap::getPiece(const glm::ivec3& cell)
{
    const auto place = _cells.find(toCellKey(cell));
    return place == _cells.end() ? NONE : getUnion(place->second.piece);
}

std::uint32_t PieceMap::getUnion(std::uint32_t piece)
{
    return static_cast<std::uint32_t>(_unions.find(static_cast<std::int32_t>(piece)));
}

bool PieceMap::mayBeConnected(const glm::ivec3& cell, const glm::ivec3& other) const
{
    const std::int32_t component = _components[_cells.at(toCellKey(cell)).piece];
    const std::int32_t otherComponent = _components[_cells.at(toCellKey(other)).piece];
    return component == NO_COMPONENT || otherComponent == NO_COMPONENT || component == otherComponent;
}

void PieceMap::add(const Join& join)
{
    for (const Join::Change& change : join.recolored)
        _cells.at(toCellKey(change.cell)).color = change.color;
    unite(getPiece(join.begin), getPiece(join.end));
    const std::uint32_t joined = getPiece(join.end);
    for (const Join::Change& change : join.added)
    {
        _cells.emplace(toCellKey(change.cell), Cell{change.color, joined});
        _members[joined].push_back(change.cell);
    }
    for (const Join::Change& change : join.added)
        for (const int step : {-1, 1})
            if (const std::uint32_t other = getPiece(change.cell + glm::ivec3(0, 0, step)); other != NONE)
                unite(joined, other);
}

void PieceMap::unite(std::uint32_t piece, std::uint32_t other)
{
    piece = getUnion(piece);
    other = getUnion(other);
    if (!_unions.join(static_cast<std::int32_t>(piece), static_cast<std::int32_t>(other))) return;
    const std::uint32_t united = getUnion(piece);
    std::vector<glm::ivec3>& from = _members[united == piece ? other : piece];
    _members[united].insert(_members[united].end(), from.begin(), from.end());
    from.clear();
}

} // namespace osgLego
