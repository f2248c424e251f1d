#pragma once

#include <osgLego/data/CellKeys.h>
#include <osgLego/data/UnionFind.h>
#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/model/Join.h>
#include <osgLego/model/LayoutPieces.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The colour and the piece of each covered cell, while joins are chosen that unite pieces. One thread. */
class PieceMap
{
public:
    static constexpr std::uint32_t NONE = LayoutPieces::NONE;

    PieceMap(const LayoutProblem& problem, const LayoutPieces& pieces);

    /** Whether a cell may be added: within the grid, not below the lowest covered cell, and not covered. */
    bool isEmpty(const glm::ivec3& cell) const;
    bool isCovered(const glm::ivec3& cell) const { return _cells.contains(toCellKey(cell)); }
    /** @param cell a covered one. */
    std::uint16_t getColor(const glm::ivec3& cell) const { return _cells.at(toCellKey(cell)).color; }
    /** The piece of a cell; NONE if it is not covered. */
    std::uint32_t getPiece(const glm::ivec3& cell);
    /** The piece that a piece of the layout now belongs to: the one with the least index. */
    std::uint32_t getUnion(std::uint32_t piece);
    /** The covered cells of a piece. @param piece a result of getPiece() or getUnion(). */
    const std::vector<glm::ivec3>& getCells(std::uint32_t piece) const { return _members[piece]; }

    /** Whether some layout of the cells at the beginning may connect the pieces of two covered cells. */
    bool mayBeConnected(const glm::ivec3& cell, const glm::ivec3& other) const;

    /** Change cells, and unite the pieces that are connected then. */
    void add(const Join& join);

private:
    struct Cell
    {
        std::uint16_t color = LayoutCell::ANY_COLOR;
        std::uint32_t piece = 0;
    };

    void unite(std::uint32_t piece, std::uint32_t other);

    glm::ivec3 _size;
    int _ground; //!< the height of the lowest cells
    std::unordered_map<CellKey, Cell> _cells;
    std::vector<std::vector<glm::ivec3>> _members;
    std::vector<std::int32_t> _components; //!< for each piece, a result of findPossibleComponents()
    UnionFind _unions;
};

} // namespace osgLego
