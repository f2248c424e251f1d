#pragma once

#include <osgLego/data/CellKeys.h>
#include <osgLego/layout/LayoutProblem.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The pieces of a layout: sets of parts that studs hold together, directly or through others. The piece with the most
 * cells has the index 0; the others follow in the order of their size. */
class LayoutPieces
{
public:
    static constexpr std::uint32_t NONE = 0xffffffff;

    explicit LayoutPieces(const LaidParts& parts);

    std::size_t getCount() const { return _cells.size(); }
    /** The cells of a piece, in the order of its parts. */
    const std::vector<glm::ivec3>& getCells(std::size_t piece) const { return _cells[piece]; }
    std::size_t countParts(std::uint32_t piece) const;
    /** The piece of a cell; NONE if no part covers it. */
    std::uint32_t find(const glm::ivec3& cell) const;

private:
    std::unordered_map<CellKey, std::uint32_t> _partOfCell;
    std::vector<std::uint32_t> _pieceOfPart;
    std::vector<std::vector<glm::ivec3>> _cells;
};

} // namespace osgLego
