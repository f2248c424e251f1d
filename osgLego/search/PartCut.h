#pragma once

#include <osgLego/data/UnionFind.h>
#include <osgLego/layout/PartMap.h>
#include <osgLego/layout/PartSizes.h>
#include <osgLego/search/LayoutRegion.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego
{

/** Determines how a layout would change if a part were laid over others: these are cut, and the strips of them that
 * remain become parts.
 *
 * Keeps its memory from one part to the next. One thread at a time. */
class PartCut
{
public:
    using Index = CellLattice::Index;

    /** A part to be laid. */
    struct Piece
    {
        Index anchor = CellLattice::NONE;
        PartShape shape;
    };

    PartCut(const PartMap& map, const PartSizes& sizes) : _map(map), _sizes(sizes) {}

    /** Find the parts that a part would cut.
     * @param bridge a part. Its lowest corner exists.
     * @return false if cells are missing, it was never made in their colour, or it would cut parts that may not change.
     */
    bool cover(const Piece& bridge, const LayoutRegion& region);
    /** Whether the part touches parts above or below that are in different components. Valid after cover().
     * @param components sets of cells; cells above each other are in one set. */
    bool touchesSeveral(UnionFind& components) const;
    /** Divide the parts that it cuts into strips, as few as possible. Valid after cover().
     * @return false if some were never made. */
    bool divide();

    /** The part, then the strips. Valid after divide(), as all below. */
    const std::vector<Piece>& getPieces() const { return _pieces; }
    /** The number of parts that the layout would have more. */
    int countAdded() const { return static_cast<int>(_pieces.size()) - static_cast<int>(_cuts.size()); }
    /** Whether the part and each strip touch a part above or below. */
    bool touchesAll() const;
    /** Whether all parts that are connected now would still be. The part itself may be alone. Examines a limited number
     * of parts around, so that it returns false for some that would be. */
    bool keepsConnections();

private:
    /** Cells along x and y. */
    struct Rectangle
    {
        std::array<int, 2> begin{};
        std::array<int, 2> end{};
    };

    /** A part that is cut. */
    struct Cut
    {
        Index anchor = CellLattice::NONE;
        std::uint16_t color = LayoutCell::ANY_COLOR;
        Rectangle covered;          //!< by the part laid
        std::size_t firstPiece = 0; //!< of the strips that remain
        bool isTouched = false;     //!< whether the part laid takes connections of this one
    };

    bool addCell(Index cell, const std::array<int, 2>& place, const LayoutRegion& region);
    bool divide(Cut& cut);
    bool addStrips(const Cut& cut, int layer, int height);
    bool addStripsAlong(std::size_t axis, const Cut& cut, int layer, int height, std::vector<Piece>& strips) const;
    bool addStrip(const Cut& cut, const Rectangle& strip, int layer, int height, std::vector<Piece>& strips) const;
    std::vector<Cut>::iterator findCut(Index anchor);
    std::size_t findPiece(Index cell) const;
    std::int32_t addOutside(Index anchor);
    void connectPieces();
    void connectOutside(std::size_t end);
    bool areConnected();

    template <typename Visit>
    void visitContacts(const Piece& piece, Visit visit) const;

    const PartMap& _map;
    const PartSizes& _sizes;
    Piece _bridge;
    std::vector<Piece> _pieces;
    std::vector<Piece> _strips;
    std::vector<Piece> _otherStrips;
    std::vector<Cut> _cuts;
    UnionFind _sets;             //!< of pieces, then of parts around them
    std::vector<Index> _outside; //!< parts around the pieces
    std::size_t _numConnected = 0;
    std::vector<std::int32_t> _numbers;   //!< of each part in _outside, in _sets
    std::vector<std::uint32_t> _searches; //!< for each part, the last search that numbered it
    std::uint32_t _numSearches = 0;
};

} // namespace osgLego
